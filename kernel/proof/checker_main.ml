(* The driver of the extracted checker: reads files, and calls checker.ml for everything that is
   proved.  What it adds and has to be trusted for: reading, the conversion of numbers, and saying
   what the checker answered.  The search for the correspondence of two tables need not be trusted:
   [Checker.certificate_ok] tests what it found.

     checker tie                      compare the stream of the C++ kernel on standard input
     checker replay LOG [--table]     follow a flip log; with --table print where it ends
     checker verify FROM TO LOG       check a certificate

   Exit codes: 0 holds, 1 does not hold, 2 unusable input or usage. *)

open Checker

exception Unusable of string

let unusable fmt = Printf.ksprintf (fun s -> raise (Unusable s)) fmt

(* Numbers *)

(* Small numbers are kept and share their leading digits, which saves most of the memory. *)
let rec build small k =
  if k <= 1 then XH
  else
    let rest = if k / 2 < Array.length small then small.(k / 2) else build small (k / 2) in
    if k land 1 = 0 then XO rest else XI rest

let small =
  let kept = Array.make (1 lsl 20) XH in
  for k = 2 to Array.length kept - 1 do
    let rest = kept.(k / 2) in
    kept.(k) <- (if k land 1 = 0 then XO rest else XI rest)
  done;
  kept

let positive_of k = if k < Array.length small then small.(max k 0) else build small k

let rec int_of_positive = function
  | XH -> 1
  | XO p -> 2 * int_of_positive p
  | XI p -> (2 * int_of_positive p) + 1

let int_of_n = function N0 -> 0 | Npos p -> int_of_positive p

(* Halfedge h is h + 2 and vertex v is v + 1; what is below 0 becomes something out of range. *)
let beyond = 1 lsl 40
let dart h = positive_of (if h < 0 then 1 else h + 2)
let label v = positive_of (if v < 0 then beyond else v + 1)
let edges_of log = List.rev (List.rev_map (fun e -> positive_of (e + 1)) log)
let halfedge_of p = int_of_positive p - 2
let vertex_of p = int_of_positive p - 1

type surface = { vertices : int; entries : (int * int) array }

let edges s = Array.length s.entries / 2
let size s = positive_of (edges s)

let table_of entries =
  let tb = ref M.empty in
  Array.iteri (fun h (n, o) -> tb := M.add (dart h) (dart n, label o) !tb) entries;
  !tb

let entries_of count tb =
  Array.init count (fun h ->
      match get (dart h) tb with
      | Some (n, o) -> (halfedge_of n, vertex_of o)
      | None -> (-1, -1))

let audit_of vertices count tb =
  if vertices < 1 || count < 2 then None
  else
    match audit (label (vertices - 1)) (positive_of (count / 2)) tb with
    | Some (f, g) -> Some (int_of_n f, int_of_n g)
    | None -> None

(* The stream of the C++ kernel *)

let line_number = ref 0

let tie () =
  let vertices = ref 0 and count = ref 0 and tb = ref M.empty in
  let flips = ref 0 and unflips = ref 0 and refused = ref 0 in
  let tables = ref 0 and entries = ref 0 in
  let audits = ref 0 and invalid = ref 0 in
  let next_line () =
    incr line_number;
    try input_line stdin with End_of_file -> unusable "line %d: the stream ends early" !line_number
  in
  let differ fmt =
    Printf.ksprintf
      (fun s -> Printf.printf "line %d: %s\n" !line_number s; exit 1) fmt
  in
  let read_entries () =
    let line = next_line () in
    let at = ref 0 in
    let number () =
      while !at < String.length line && line.[!at] = ' ' do incr at done;
      let from = !at in
      while !at < String.length line && line.[!at] <> ' ' do incr at done;
      match int_of_string_opt (String.sub line from (!at - from)) with
      | Some k -> k
      | None -> unusable "line %d: not a table of %d halfedges" !line_number !count
    in
    Array.init !count (fun _ -> let n = number () in let o = number () in (n, o))
  in
  let compare_table () =
    let expected = read_entries () in
    incr tables;
    entries := !entries + (2 * !count);
    if not (same_table (positive_of (!count / 2)) !tb (table_of expected)) then begin
      let ours = entries_of !count !tb in
      Array.iteri
        (fun h (n, o) ->
          let n', o' = ours.(h) in
          if (n, o) <> (n', o') then
            differ "halfedge %d is (%d, %d), the checker says (%d, %d)" h n o n' o')
        expected;
      differ "the tables differ"
    end
  in
  (try
     while true do
       incr line_number;
       let line = input_line stdin in
       match String.split_on_char ' ' line with
       | [ "table"; v; h ] ->
         vertices := int_of_string v;
         count := int_of_string h;
         tb := table_of (read_entries ());
         if !count < 2 || !count land 1 = 1 then unusable "line %d: no edges" !line_number
       | [ ("flip" | "unflip") as verb; e ] ->
         let h = dart (2 * int_of_string e) in
         let outcome = if verb = "flip" then flip_table h !tb else unflip_table h !tb in
         incr (if verb = "flip" then flips else unflips);
         (match (next_line (), outcome) with
          | "refused", Refused -> incr refused
          | "done", Done after -> tb := after
          | "table", Done after -> tb := after; compare_table ()
          | said, Done _ -> differ "%s %s: %s, the checker does it" verb e said
          | said, Refused -> differ "%s %s: %s, the checker refuses it" verb e said
          | said, Broken -> differ "%s %s: %s, the checker finds no such entries" verb e said)
       | [ "audit" ] ->
         incr audits;
         let said = next_line () in
         let ours =
           match audit_of !vertices !count !tb with
           | Some (f, g) -> Printf.sprintf "valid %d %d %d %d" !vertices (!count / 2) f g
           | None -> incr invalid; "invalid"
         in
         if said <> ours then differ "%s, the checker says %s" said ours
       | _ -> unusable "line %d: not understood: %s" !line_number line
     done
   with End_of_file -> ());
  if !flips = 0 then unusable "no flips on standard input";
  Printf.printf
    "agree: %d flips and %d inverse ones (%d refused), %d tables of %d entries, %d audits (%d \
     invalid)\n"
    !flips !unflips !refused !tables !entries !audits !invalid

(* Files *)

let read_file name =
  try
    let ch = open_in_bin name in
    let text = really_input_string ch (in_channel_length ch) in
    close_in ch;
    text
  with Sys_error message -> unusable "%s" message

(* The words of a text without its comments. *)
let words text =
  let strip line =
    match String.index_opt line '#' with Some i -> String.sub line 0 i | None -> line
  in
  String.split_on_char '\n' text
  |> List.concat_map (fun line ->
         String.map (fun c -> if c = '\t' || c = '\r' then ' ' else c) (strip line)
         |> String.split_on_char ' '
         |> List.filter (fun w -> w <> ""))
  |> List.to_seq

let reader name text =
  let rest = ref (words text) in
  let word () =
    match !rest () with
    | Seq.Nil -> unusable "%s: ends early" name
    | Seq.Cons (w, more) -> rest := more; w
  in
  let expect w =
    let found = word () in
    if found <> w then unusable "%s: %s where %s is expected" name found w
  in
  let number () =
    let w = word () in
    match int_of_string_opt w with
    | Some k when k >= 0 -> k
    | _ -> unusable "%s: %s where a number is expected" name w
  in
  (word, expect, number)

let read_table expect number name text =
  expect "vertices";
  let vertices = number () in
  expect "halfedges";
  let count = number () in
  if count < 2 || count land 1 = 1 || vertices < 1 || count > String.length text then
    unusable "%s: no table" name;
  let entries = Array.make count (0, 0) in
  for h = 0 to count - 1 do
    let n = number () in
    let o = number () in
    entries.(h) <- (n, o)
  done;
  { vertices; entries }

let read_surface name =
  let text = read_file name in
  let word, expect, number = reader name text in
  match word () with
  | "tightflip-surface" | "tightflip-triangulation" ->
    expect "1";
    read_table expect number name text
  | _ -> unusable "%s: neither a tightflip-surface nor a tightflip-triangulation" name

(* FNV-1a, 64 bits, over little-endian 32-bit words. *)
let check_sum surface log =
  let sum = ref 0xcbf29ce484222325L in
  let add word =
    for i = 0 to 3 do
      let byte = (word lsr (8 * i)) land 255 in
      sum := Int64.mul (Int64.logxor !sum (Int64.of_int byte)) 0x100000001b3L
    done
  in
  add surface.vertices;
  add (Array.length surface.entries);
  Array.iter (fun (n, o) -> add n; add o) surface.entries;
  List.iter add log;
  !sum

let magic = "\x89TFLIPS\n"

let read_binary_log name text =
  let at = ref (String.length magic) in
  let byte () =
    if !at >= String.length text then unusable "%s: ends early" name;
    incr at;
    Char.code text.[!at - 1]
  in
  let word () =
    let a = byte () in let b = byte () in let c = byte () in let d = byte () in
    a lor (b lsl 8) lor (c lsl 16) lor (d lsl 24)
  in
  if word () <> 1 then unusable "%s: unknown version" name;
  let vertices = word () in
  let count = word () in
  if count < 2 || count land 1 = 1 || vertices < 1 || 8 * count > String.length text then
    unusable "%s: no table" name;
  let entries = Array.make count (0, 0) in
  for h = 0 to count - 1 do
    let n = word () in
    let o = word () in
    entries.(h) <- (n, o)
  done;
  let number () =
    let value = ref 0 and shift = ref 0 and more = ref true in
    while !more do
      if !shift > 35 then unusable "%s: byte %d: number too long" name !at;
      let b = byte () in
      value := !value lor ((b land 127) lsl !shift);
      shift := !shift + 7;
      more := b land 128 <> 0
    done;
    !value
  in
  let flips = word () in
  let log = ref [] in
  for _ = 1 to flips do log := number () :: !log done;
  let low = word () in
  let high = word () in
  if !at <> String.length text then unusable "%s: something follows the check sum" name;
  let sum = Int64.logor (Int64.of_int low) (Int64.shift_left (Int64.of_int high) 32) in
  ({ vertices; entries }, List.rev !log, sum)

let read_text_log name text =
  let word, expect, number = reader name text in
  expect "tightflip-flip-log";
  expect "1";
  let surface = read_table expect number name text in
  expect "flips";
  let flips = number () in
  let log = ref [] in
  for _ = 1 to flips do log := number () :: !log done;
  expect "check";
  let sum = word () in
  match Int64.of_string_opt ("0x" ^ sum) with
  | Some sum -> (surface, List.rev !log, sum)
  | None -> unusable "%s: %s is no check sum" name sum

let read_log name =
  let text = read_file name in
  let has_magic =
    String.length text >= String.length magic && String.sub text 0 (String.length magic) = magic
  in
  let surface, log, sum =
    if has_magic then read_binary_log name text else read_text_log name text
  in
  if sum <> check_sum surface log then unusable "%s: the check sum does not fit" name;
  (surface, log)

let print_table s =
  Printf.printf "tightflip-triangulation 1\nvertices %d\nhalfedges %d\n" s.vertices
    (Array.length s.entries);
  Array.iter (fun (n, o) -> Printf.printf "%d %d\n" n o) s.entries;
  print_string "end\n"

let refuse fmt = Printf.ksprintf (fun s -> Printf.printf "refused: %s\n" s; exit 1) fmt

let audited what s =
  match audit_of s.vertices (Array.length s.entries) (table_of s.entries) with
  | Some (f, g) -> (f, g)
  | None -> refuse "%s does not pass the audit" what

(* Follows the log; the table where it ends. *)
let follow start log =
  match replay (size start) (edges_of log) (table_of start.entries) with
  | Done reached, _ -> reached
  | outcome, rest ->
    refuse "flip %d: %s"
      (List.length log - List.length rest + 1)
      (match outcome with Refused -> "the opposite corners coincide" | _ -> "no such edge")

let replay_log name with_table =
  let start, log = read_log name in
  ignore (audited "the start" start);
  let reached = follow start log in
  match audit_of start.vertices (Array.length start.entries) reached with
  | None -> refuse "the end does not pass the audit"
  | Some (f, g) ->
    if with_table then
      print_table { start with entries = entries_of (Array.length start.entries) reached }
    else
      Printf.printf "holds: %d flips; %d vertices, %d edges, %d faces, genus %d\n"
        (List.length log) start.vertices (edges start) f g

(* The correspondence of two labelled surfaces, from one pair of halfedges on.  Any answer will do,
   for the checker tests it; this and the next function need not be trusted. *)
let correspondence a b =
  let count = Array.length a in
  let target s h = snd s.(fst s.(h)) in
  let try_from first =
    let image = Array.make count (-1) in
    let stack = Stack.create () in
    let ok = ref true in
    let meet x y =
      if image.(x) < 0 then begin
        image.(x) <- y;
        Stack.push x stack
      end
      else if image.(x) <> y then ok := false
    in
    meet 0 first;
    while !ok && not (Stack.is_empty stack) do
      let x = Stack.pop stack in
      let y = image.(x) in
      if snd a.(x) <> snd b.(y) then ok := false
      else begin
        meet (x lxor 1) (y lxor 1);
        meet (fst a.(x)) (fst b.(y))
      end
    done;
    if !ok then Some image else None
  in
  let rec search h =
    if h >= Array.length b then None
    else if snd b.(h) = snd a.(0) && target b h = target a 0 then
      match try_from h with Some image -> Some image | None -> search (h + 1)
    else search (h + 1)
  in
  let to_map image =
    let m = ref M.empty in
    Array.iteri (fun x y -> m := M.add (dart x) (dart y) !m) image;
    !m
  in
  if Array.length b <> count then None
  else
    match search 0 with
    | image -> Option.map to_map image
    | exception Invalid_argument _ -> None

(* Where a log ends, on an array, to find the correspondence there. *)
let guess_end start log =
  let s = Array.copy start in
  let next h = fst s.(h) in
  let turn e =
    let h = 2 * e and t = (2 * e) + 1 in
    let h1 = next h and t1 = next t in
    let b = next h1 and d = next t1 in
    let c = snd s.(b) and o = snd s.(d) in
    s.(h) <- (b, o);
    s.(t) <- (d, c);
    s.(b) <- (t1, c);
    s.(t1) <- (h, snd s.(t1));
    s.(d) <- (h1, o);
    s.(h1) <- (t, snd s.(h1))
  in
  match List.iter turn log with () -> Some s | exception Invalid_argument _ -> None

(* Why the checker did not pass a certificate, in words. *)
let explain a b start log m1 =
  let _, g_a = audited "the first surface" a and _, g_b = audited "the second surface" b in
  if a.vertices <> b.vertices || edges a <> edges b || g_a <> g_b then
    refuse "the ends differ in vertices or genus";
  ignore (audited "the log's start" start);
  if start.vertices <> a.vertices || m1 = None then refuse "the log starts elsewhere";
  ignore (follow start log);
  refuse "the log ends elsewhere"

let verify from_name to_name log_name =
  let a = read_surface from_name and b = read_surface to_name in
  let start, log = read_log log_name in
  let m1 = correspondence a.entries start.entries in
  let m2 =
    Option.bind (guess_end start.entries log) (fun reached -> correspondence reached b.entries)
  in
  match (m1, m2) with
  | Some to_start, Some to_end
    when a.vertices = b.vertices
         && a.vertices = start.vertices
         && certificate_ok (label (a.vertices - 1)) (size a) (table_of a.entries) to_start
              (table_of start.entries) (edges_of log) to_end (table_of b.entries) ->
    Printf.printf "holds: %d flips join the two surfaces of %d vertices\n" (List.length log)
      a.vertices
  | _ -> explain a b start log m1

let usage = "checker tie | checker replay LOG [--table] | checker verify FROM TO LOG"

let () =
  try
    match List.tl (Array.to_list Sys.argv) with
    | [ "tie" ] -> tie ()
    | [ "replay"; log ] -> replay_log log false
    | [ "replay"; log; "--table" ] -> replay_log log true
    | [ "verify"; a; b; log ] -> verify a b log
    | _ -> unusable "usage: %s" usage
  with
  | Unusable message -> prerr_endline ("checker: " ^ message); exit 2
  | Failure message ->
    prerr_endline (Printf.sprintf "checker: line %d: %s" !line_number message);
    exit 2

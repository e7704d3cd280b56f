(* The flip, the audit and the checker of flip logs as programs on tables.

   Only Coq's standard library is used here, so that what is extracted is plain code.  What the
   programs mean is proved in refinement.v.

   Halfedge h (0, 1, 2, ...) is the positive number h + 2, so that its last binary digit tells the
   two directions of an edge apart and the digits before it number the edge, from 1: the twin of
   halfedge h, which is h xor 1, has the other last digit.  Vertex v is the positive number v + 1.
   A table gives for each halfedge the next one in its face and the vertex where it starts. *)

From Coq Require Import PArith NArith List Bool.
Import ListNotations.

(* Finite maps from positive numbers: a tree that branches on the binary digits. *)
Module M.

Inductive t (A : Type) :=
| Leaf
| Node (zero : t A) (here : option A) (one : t A).

Definition empty (A : Type) : t A := Leaf A.

Fixpoint find {A : Type} (p : positive) (m : t A) {struct m} : option A :=
  match m with
  | Leaf _ => None
  | Node _ zero here one =>
    match p with
    | xH => here
    | xO q => find q zero
    | xI q => find q one
    end
  end.

Fixpoint add {A : Type} (p : positive) (a : A) (m : t A) {struct p} : t A :=
  match p, m with
  | xH, Leaf _ => Node A (Leaf A) (Some a) (Leaf A)
  | xO q, Leaf _ => Node A (add q a (Leaf A)) None (Leaf A)
  | xI q, Leaf _ => Node A (Leaf A) None (add q a (Leaf A))
  | xH, Node _ zero _ one => Node A zero (Some a) one
  | xO q, Node _ zero here one => Node A (add q a zero) here one
  | xI q, Node _ zero here one => Node A zero here (add q a one)
  end.

Definition mem {A : Type} (p : positive) (m : t A) : bool :=
  match find p m with
  | Some _ => true
  | None => false
  end.

Lemma gempty (A : Type) (p : positive) : find p (empty A) = None.
Proof. reflexivity. Qed.

(* What was added is found, and nothing else has changed. *)
Lemma gss (A : Type) (p : positive) (a : A) (m : t A) : find p (add p a m) = Some a.
Proof. revert m; induction p as [q IH|q IH|]; intros [|zero here one]; simpl; auto. Qed.

Lemma gso (A : Type) (p q : positive) (a : A) (m : t A) :
  p <> q -> find p (add q a m) = find p m.
Proof.
revert p m; induction q as [q IH|q IH|]; intros [p|p|] [|zero here one] neq; simpl; auto;
  try (rewrite IH; [auto | congruence]); congruence.
Qed.

Lemma mem_find (A : Type) (p : positive) (m : t A) :
  mem p m = match find p m with Some _ => true | None => false end.
Proof. reflexivity. Qed.

End M.

Definition table := M.t (positive * positive).

Definition get (p : positive) (tb : table) : option (positive * positive) := M.find p tb.

Definition twin_dart (p : positive) : positive :=
  match p with
  | xO e => xI e
  | xI e => xO e
  | xH => xH
  end.

(* What becomes of a flip.  Broken: the table has no entry where one is needed. *)
Inductive outcome := Done (tb : table) | Refused | Broken.

(* Turns the edge of h so that [turned] becomes its side from the corner behind to the corner in
   front: eight numbers are written, and all are read from the old table. *)
Definition turn_edge (h turned : positive) (tb : table) : outcome :=
  let t := twin_dart h in
  match get h tb, get t tb with
  | Some (h1, _), Some (t1, _) =>
    match get h1 tb, get t1 tb with
    | Some (b, origin_h1), Some (d, origin_t1) =>
      match get b tb, get d tb with
      | Some (_, corner_h), Some (_, corner_t) =>
        if Pos.eqb corner_h corner_t then Refused
        else
          let turned_back := twin_dart turned in
          Done (M.add turned (b, corner_t) (M.add turned_back (d, corner_h)
               (M.add b (t1, corner_h) (M.add t1 (turned, origin_t1)
               (M.add d (h1, corner_t) (M.add h1 (turned_back, origin_h1) tb))))))
      | _, _ => Broken
      end
    | _, _ => Broken
    end
  | _, _ => Broken
  end.

(* The flip of the edge of h, and its inverse. *)
Definition flip_table (h : positive) (tb : table) : outcome := turn_edge h h tb.
Definition unflip_table (h : positive) (tb : table) : outcome := turn_edge h (twin_dart h) tb.

(* A test of all numbers from 1 to n, and a list of what a function finds there. *)
Definition all_upto (n : positive) (f : positive -> bool) : bool :=
  snd (Pos.iter (fun st : positive * bool =>
                   (Pos.succ (fst st), if snd st then f (fst st) else false)) (1%positive, true) n).

Definition collect_upto {A : Type} (n : positive) (f : positive -> A -> A) (a : A) : A :=
  snd (Pos.iter (fun st : positive * A => (Pos.succ (fst st), f (fst st) (snd st)))
                (1%positive, a) n).

(* A halfedge of one of the edges 1 to n. *)
Definition dart_in (n : positive) (p : positive) : bool :=
  match p with
  | xO e | xI e => Pos.leb e n
  | xH => false
  end.

(* Both halfedges of every edge. *)
Definition all_darts (n : positive) (f : positive -> bool) : bool :=
  all_upto n (fun e => f (xO e) && f (xI e)).

(* One halfedge: numbers in range, its face a triangle, its ends different, its twin runs back. *)
Definition dart_ok (v n : positive) (tb : table) (p : positive) : bool :=
  match get p tb with
  | Some (p1, o) =>
    dart_in n p1 && Pos.leb o v &&
    match get p1 tb, get (twin_dart p) tb with
    | Some (p2, o1), Some (_, ot) =>
      Pos.eqb ot o1 && negb (Pos.eqb o o1) &&
      match get p2 tb with
      | Some (p3, _) => Pos.eqb p3 p
      | None => false
      end
    | _, _ => false
    end
  | None => false
  end.

(* All that steps lead to from seeds: a list of what is still to be looked at, and what was seen. *)
Definition seen_set := M.t unit.

Definition visit (st : list positive * seen_set) (p : positive) : list positive * seen_set :=
  if M.mem p (snd st) then st else (p :: fst st, M.add p tt (snd st)).

Definition search_step (steps : positive -> list positive) (st : list positive * seen_set) :=
  match fst st with
  | nil => st
  | p :: rest => fold_left visit (steps p) (rest, snd st)
  end.

Definition search (steps : positive -> list positive) (seeds : list positive) (n : positive) :=
  snd (Pos.iter (search_step steps) (fold_left visit seeds (nil, M.empty unit)) n).

(* Turning about a vertex, and going to a neighbour. *)
Definition sigma_steps (tb : table) (p : positive) : list positive :=
  match get (twin_dart p) tb with
  | Some (x, _) => [x]
  | None => []
  end.

Definition link_steps (tb : table) (p : positive) : list positive :=
  match get p tb with
  | Some (x, _) => [twin_dart p; x]
  | None => [twin_dart p]
  end.

(* One halfedge for each vertex. *)
Definition note_origin (tb : table) (p : positive) (m : M.t positive) : M.t positive :=
  match get p tb with
  | Some (_, o) => M.add o p m
  | None => m
  end.

Definition representatives (n : positive) (tb : table) : M.t positive :=
  collect_upto n (fun e m => note_origin tb (xO e) (note_origin tb (xI e) m)) (M.empty positive).

Definition seeds_of (v : positive) (m : M.t positive) : list positive :=
  collect_upto v (fun k l => match M.find k m with Some p => p :: l | None => l end) nil.

Definition seen_all (n : positive) (seen : seen_set) : bool :=
  all_darts n (fun p => M.mem p seen).

(* Every vertex has a halfedge, and its halfedges are one cycle. *)
Definition vertices_ok (v n : positive) (tb : table) : bool :=
  let m := representatives n tb in
  all_upto v (fun k => M.mem k m) &&
  seen_all n (search (sigma_steps tb) (seeds_of v m) (xO n)).

Definition connected_ok (n : positive) (tb : table) : bool :=
  seen_all n (search (link_steps tb) [2%positive] (xO n)).

(* The audit: the number of faces and the genus of a connected surface without loops. *)
Definition audit (v n : positive) (tb : table) : option (N * N) :=
  if all_darts n (dart_ok v n tb) && vertices_ok v n tb && connected_ok n tb then
    let f := (Npos (xO n) / 3)%N in
    let g := ((Npos n + 2 - (Npos v + f)) / 2)%N in
    if N.eqb (Npos v + f + 2 * g) (Npos n + 2) then Some (f, g) else None
  else None.

(* Flips one after the other; also what is left of the log where one cannot be done. *)
Fixpoint replay (n : positive) (log : list positive) (tb : table) : outcome * list positive :=
  match log with
  | nil => (Done tb, nil)
  | e :: rest =>
    if Pos.leb e n then
      match flip_table (xO e) tb with
      | Done tb' => replay n rest tb'
      | stop => (stop, log)
      end
    else (Broken, log)
  end.

(* Whether m, a number for each halfedge, makes one labelled surface of two tables. *)
Definition same_at (n : positive) (m : M.t positive) (tb tb' : table) (p : positive) : bool :=
  match M.find p m with
  | Some q =>
    dart_in n q &&
    match get p tb, get q tb', M.find (twin_dart p) m with
    | Some (p1, o), Some (q1, o'), Some q_twin =>
      Pos.eqb o o' && Pos.eqb q_twin (twin_dart q) &&
      match M.find p1 m with
      | Some q2 => Pos.eqb q2 q1
      | None => false
      end
    | _, _, _ => false
    end
  | None => false
  end.

Definition same_by (n : positive) (m : M.t positive) (tb tb' : table) : bool :=
  all_darts n (same_at n m tb tb').

(* Equal tables, entry by entry. *)
Definition same_table (n : positive) (tb tb' : table) : bool :=
  all_darts n (fun p =>
    match get p tb, get p tb' with
    | Some (x, o), Some (x', o') => Pos.eqb x x' && Pos.eqb o o'
    | _, _ => false
    end).

(* A certificate: both ends pass the audit, the log starts at the first and ends in the second,
   as labelled surfaces (m1 and m2 say how), and every flip of it is allowed. *)
Definition certificate_ok (v n : positive) (a : table) (m1 : M.t positive) (start : table)
    (log : list positive) (m2 : M.t positive) (b : table) : bool :=
  match audit v n a, audit v n start, audit v n b with
  | Some _, Some _, Some _ =>
    same_by n m1 a start &&
    match replay n log start with
    | (Done reached, _) => same_by n m2 reached b
    | _ => false
    end
  | _, _, _ => false
  end.

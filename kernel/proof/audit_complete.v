(* The audit rejects nothing that it should pass: a table that represents a well-formed, loopless,
   connected surface passes [audit], which says its genus.  With [audit_sound] of refinement.v: the
   audit passes exactly the tables of such surfaces ([audit_exact]). *)

From Coq Require Import PArith NArith Lia.
From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants genus reach tables refinement.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Loops that count, to their end *)

Lemma all_upto_intro n (f : positive -> bool) :
  (forall k, (k <= n)%positive -> f k) -> all_upto n f.
Proof.
move=> all_f; have step k (b : bool) : (k <= n)%positive -> b -> (if b then f k else false).
  by move=> k_le ->; apply: all_f.
by have [_] := @iter_count bool (fun k b => if b then f k else false) (fun _ b => b) true n
  isT step _ erefl.
Qed.

(* A search that may take as many steps as there are darts finds all that steps lead to. *)
Section SearchComplete.

Variable n : positive.
Let D := table_darts n.
Let name : D -> positive := @dart_name n.
Variables (steps : positive -> list positive) (nb : D -> seq D).
Hypothesis steps_nb : forall y, steps (name y) = map name (nb y).
Implicit Types (st dn l : seq D) (S : list positive * seen_set).

(* st is still to be looked at, dn is done; both have been seen, and nothing else. *)
Let state st dn S :=
  [/\ S.1 = map name st, uniq (st ++ dn) & forall y, M.mem (name y) S.2 = (y \in st ++ dn)].

Lemma visit_state st dn S y : state st dn S ->
  exists st', [/\ state st' dn (visit S (name y)), y \in st' ++ dn
                & {subset st ++ dn <= st' ++ dn}].
Proof.
case=> stack_eq st_uniq seen_eq; rewrite /visit seen_eq.
case in_y: (y \in st ++ dn); first by exists st; split.
exists (y :: st); split; last by move=> z; rewrite inE orbC => ->.
- split=> [||z] /=; rewrite ?stack_eq ?in_y //.
  rewrite inE M.mem_find; case: (z =P y) => [->|neq]; first by rewrite M.gss.
  by rewrite M.gso -?M.mem_find ?seen_eq // => /(@dart_name_inj n).
- by rewrite inE eqxx.
Qed.

Lemma visits_state l st dn S : state st dn S ->
  exists st', [/\ state st' dn (List.fold_left visit (map name l) S), {subset l <= st' ++ dn}
                & {subset st ++ dn <= st' ++ dn}].
Proof.
elim: l st S => [|y l IHl] st S okS /=; first by exists st; split=> // z.
have [st1 [ok1 y1 sub1]] := visit_state y okS.
have [st2 [ok2 l2 sub2]] := IHl _ _ ok1.
exists st2; split=> // z; last by move=> /sub1 /sub2.
by rewrite inE => /orP[/eqP->|/l2 //]; apply: sub2.
Qed.

Lemma search_complete sd : exists T : pred D,
  [/\ forall y, M.mem (name y) (search steps (map name sd) (xO n)) = T y,
      forall y, y \in sd -> T y & forall y z, T y -> z \in nb y -> T z].
Proof.
pose inv k S := exists st dn, [/\ state st dn S, {subset sd <= st ++ dn},
  forall y, y \in dn -> {subset nb y <= st ++ dn} & st = [::] \/ size dn = k].
pose S0 := List.fold_left visit (map name sd) (nil, M.empty unit).
have inv0 : inv 0 S0.
  have [|st [ok sub _]] := @visits_state sd [::] [::] (nil, M.empty unit).
    by split=> // y; rewrite M.mem_find M.gempty.
  by exists st, [::]; split=> //; right.
have inv_step k S : inv k S -> inv k.+1 (search_step steps S).
  case=> st [dn [okS sd_in closed size_dn]]; case: st => [|y st] in okS sd_in closed size_dn *.
    case: okS => stack_eq u seen_eq; exists [::], dn; rewrite /search_step stack_eq.
    by split=> //; left.
  case: okS => stack_eq u seen_eq; rewrite /search_step stack_eq /= steps_nb.
  have perm_y : perm_eq ((y :: st) ++ dn) (st ++ y :: dn).
    by rewrite perm_sym perm_catC /= perm_cons perm_catC.
  have [|st' [ok' nb_in sub]] := @visits_state (nb y) st (y :: dn) (map name st, S.2).
    by split=> // [|z]; rewrite -?(perm_uniq perm_y) // seen_eq (perm_mem perm_y).
  have sub_y z : z \in (y :: st) ++ dn -> z \in st' ++ y :: dn.
    by rewrite (perm_mem perm_y); apply: sub.
  exists st', (y :: dn); split=> //.
  - by move=> z /sd_in; apply: sub_y.
  - move=> z; rewrite inE => /orP[/eqP->//|/closed nb_z] w /nb_z; exact: sub_y.
  - by right; case: size_dn => //= ->.
have inv_end : inv (Pos.to_nat (xO n)) (Pos.iter (search_step steps) S0 (xO n)).
  move: (xO n) => k; elim/Pos.peano_ind: k => [|k IHk]; first exact: inv_step inv0.
  by rewrite Pos.iter_succ Pos2Nat.inj_succ; apply: inv_step.
have [st [dn [[_ u seen_eq] sd_in closed size_dn]]] := inv_end.
have st0 : st = [::].
  case: size_dn => // size_dn; apply/nilP; rewrite /nilp -leqn0.
  have := max_card (mem (st ++ dn)); rewrite (card_uniqP u) size_cat size_dn.
  rewrite card_prod card_bool card_ord Pos2Nat.inj_xO multE -{2}[2 * _]add0n.
  by rewrite leq_add2r.
rewrite st0 /= in seen_eq sd_in closed.
exists (mem dn); split=> // y z y_dn; exact: closed y y_dn z.
Qed.

End SearchComplete.

(* The parts of the audit *)
Section Complete.

Variables (n m : positive) (tb : table).
Let D := table_darts n.
Let V := table_vertices m.
Variable s : surface D V.
Hypothesis rep : represents (@dart_name n) (@vertex_name m) s tb.
Hypothesis gd : good s.

Let wf : well_formed s. Proof. by case: gd. Qed.

Let get_rep x : get (dart_name x) tb = Some (dart_name (next s x), vertex_name (origin s x)).
Proof. by case: rep. Qed.

Let twin_name x : twin_dart (dart_name x) = dart_name (twin s x).
Proof. by case: rep. Qed.

Lemma small_le k (i : 'I_(Pos.to_nat k)) : (Pos.of_succ_nat i <= k)%positive.
Proof. by have /ltP := ltn_ord i; lia. Qed.

Lemma dart_in_self (x : D) : dart_in n (dart_name x).
Proof. by case: x => [[] i]; apply/Pos.leb_le; apply: small_le. Qed.

Lemma all_darts_intro (f : positive -> bool) : (forall x : D, f (dart_name x)) -> all_darts n f.
Proof.
move=> all_f; apply: all_upto_intro => e /small_number[i <-].
by rewrite (all_f (false, i)) (all_f (true, i)).
Qed.

Lemma darts_complete : all_darts n (dart_ok m n tb).
Proof.
apply: all_darts_intro => x; rewrite /dart_ok get_rep twin_name !get_rep !dart_in_self.
rewrite (next3 wf) origin_twin // !Pos.eqb_refl /= andbT.
apply/andP; split; first by apply/Pos.leb_le; apply: small_le.
by apply/negP => /Pos.eqb_eq /vertex_name_inj /eqP; apply/negP; apply: (good_loopless gd).
Qed.

Let reps := representatives n tb.

Lemma representatives_complete x : M.mem (vertex_name (origin s x)) reps.
Proof.
pose noted k (mp : M.t positive) := forall x : D, (Pos.of_succ_nat x.2 < k)%positive ->
  M.mem (vertex_name (origin s x)) mp.
have note (y : D) mp w : M.mem w mp -> M.mem w (note_origin tb (dart_name y) mp).
  rewrite /note_origin get_rep => in_mp; rewrite M.mem_find.
  have [->|neq] : w = vertex_name (origin s y) \/ w <> vertex_name (origin s y) by lia.
    by rewrite M.gss.
  by rewrite M.gso -?M.mem_find.
have note_self y mp : M.mem (vertex_name (origin s y)) (note_origin tb (dart_name y) mp).
  by rewrite /note_origin get_rep M.mem_find M.gss.
pose g e mp := note_origin tb (xO e) (note_origin tb (xI e) mp).
have start : noted 1%positive (M.empty positive) by move=> y; lia.
have step k mp : (k <= n)%positive -> noted k mp -> noted (Pos.succ k) (g k mp).
  move=> /small_number[i def_k] noted_k [b j] /= j_lt.
  have [j_lt_k|j_eq] : (Pos.of_succ_nat j < k)%positive \/ Pos.of_succ_nat j = k by lia.
    rewrite -def_k /g; apply: (note (false, i)); apply: (note (true, i)).
    exact: noted_k (b, j) j_lt_k.
  rewrite -j_eq /g; case: b; last exact: (note_self (false, j)).
  exact: (note (false, j)) _ _ (note_self (true, j) _).
have [_ noted_n] := @iter_count _ g noted (M.empty positive) n start step _ erefl.
by apply: noted_n; apply/Pos.lt_succ_r; apply: small_le.
Qed.

Lemma seeds_complete w p : M.find (vertex_name (w : V)) reps = Some p ->
  List.In p (seeds_of m reps).
Proof.
pose taken k l := forall j q, (j < k)%positive -> M.find j reps = Some q -> @List.In positive q l.
pose g k l := match M.find k reps with Some q => q :: l | None => l end.
have start : taken 1%positive nil by move=> j q; lia.
have step k l : (k <= m)%positive -> taken k l -> taken (Pos.succ k) (g k l).
  move=> _ taken_k j q j_lt found; rewrite /g.
  have [j_lt_k|j_eq] : (j < k)%positive \/ j = k by lia.
    have := taken_k j q j_lt_k found.
    by case: (M.find k reps) => //= r; right.
  by rewrite -j_eq found; left.
have [_ taken_m] := @iter_count _ g taken nil m start step _ erefl.
by apply: taken_m; apply/Pos.lt_succ_r; apply: small_le.
Qed.

Lemma names_of_list (l : list positive) :
    (forall p, List.In p l -> exists x : D, p = dart_name x) ->
  exists sd, l = map (@dart_name n) sd.
Proof.
elim: l => [|p l IHl] all_l; first by exists [::].
have [x ->] := all_l p (or_introl erefl).
have [|sd ->] := IHl; first by move=> q ql; apply: all_l; right.
by exists (x :: sd).
Qed.

Lemma in_names (x : D) sd : List.In (dart_name x) (map (@dart_name n) sd) -> x \in sd.
Proof.
elim: sd => //= y sd IHsd [/dart_name_inj->|/IHsd in_sd]; first by rewrite inE eqxx.
by rewrite inE in_sd orbT.
Qed.

Lemma vertices_complete : vertices_ok m n tb.
Proof.
have tw x : twin s x = dart_twin x.
  by apply: dart_name_inj; rewrite -twin_name twin_dart_name.
apply/andP; split.
  apply: all_upto_intro => k /small_number[w <-].
  by have [x def_w] := label_used wf w; rewrite -/(vertex_name w) -def_w representatives_complete.
have [|sd def_sd] := @names_of_list (seeds_of m reps).
  by move=> p /(seeds_sound rep)[x [-> _]]; exists x.
pose nb y := [:: sigma s y].
have nbE y : sigma_steps tb (dart_name y) = map (@dart_name n) (nb y).
  by rewrite /sigma_steps twin_name get_rep /= sigmaE.
have [T [seenT seedT closedT]] := search_complete nbE sd.
apply: all_darts_intro => x; rewrite -/reps def_sd seenT.
have := representatives_complete x; rewrite M.mem_find.
case found: (M.find _ _) => [p|] // _.
have [y [def_p same_o]] := representatives_sound rep found.
have in_sd : y \in sd by apply: in_names; rewrite -def_sd -def_p; apply: seeds_complete found.
have : x \in porbit (sigma s) y.
  by rewrite -(label_orbit wf); apply/eqP/esym/vertex_name_inj.
case/porbitP=> k ->; elim: k => [|k IHk]; first by rewrite expg0 perm1; apply: seedT.
by rewrite expgSr permM; apply: closedT IHk _; rewrite inE.
Qed.

Lemma connected_complete : connected_ok n tb.
Proof.
have n_pos : 0 < Pos.to_nat n by apply/ltP; lia.
pose nb y := [:: twin s y; next s y].
have nbE y : link_steps tb (dart_name y) = map (@dart_name n) (nb y).
  by rewrite /link_steps get_rep twin_name.
have [T [seenT seedT closedT]] := search_complete nbE [:: (false, Ordinal n_pos)].
apply: all_darts_intro => x; suff Tx : T x by have := seenT x; rewrite Tx.
apply: (@connected_all _ _ s (good_connected gd) T (false, Ordinal n_pos)) => [|y Ty|y Ty].
- by apply: seedT; rewrite inE.
- by apply: closedT Ty _; rewrite !inE eqxx.
- by apply: closedT Ty _; rewrite !inE eqxx orbT.
Qed.

Theorem audit_complete g : has_genus s g ->
  audit m n tb = Some (N.of_nat (faces s), N.of_nat g).
Proof.
case=> _ euler_eq; rewrite /audit darts_complete vertices_complete connected_complete /=.
have cardD : #|D| = 2 * Pos.to_nat n by rewrite card_prod card_bool card_ord.
have faces_eq : faces s * 3 = 2 * Pos.to_nat n by rewrite faces3.
have edges_eq : edges s * 2 = 2 * Pos.to_nat n by rewrite edges2.
have verts_eq : vertices s = Pos.to_nat m by rewrite vertices_labels // card_ord.
have -> : (N.pos n~0 / 3)%num = N.of_nat (faces s).
  have -> : N.pos n~0 = (N.of_nat (faces s) * 3)%num.
    by move: faces_eq; rewrite -!multE; lia.
  by rewrite N.div_mul.
have -> : ((N.pos n + 2 - (N.pos m + N.of_nat (faces s))) / 2)%num = N.of_nat g.
  have -> : (N.pos n + 2 - (N.pos m + N.of_nat (faces s)))%num = (N.of_nat g * 2)%num.
    by move: edges_eq euler_eq; rewrite verts_eq -!multE -!plusE; lia.
  by rewrite N.div_mul.
have -> : N.eqb (N.pos m + N.of_nat (faces s) + 2 * N.of_nat g)%num (N.pos n + 2)%num.
  apply/N.eqb_eq; move: edges_eq euler_eq; rewrite verts_eq -!multE -!plusE; lia.
by [].
Qed.

End Complete.

(* The audit passes exactly the tables of well-formed, loopless, connected surfaces. *)
Theorem audit_exact n m tb :
  (exists answer, audit m n tb = Some answer) <->
  (exists s : surface (table_darts n) (table_vertices m), table_of s tb /\ good s).
Proof.
split=> [[[f g] /audit_sound[s [rep gd _ _]]]|[s [rep gd]]]; first by exists s.
have n_pos : 0 < Pos.to_nat n by apply/ltP; lia.
have [g genus_s] :=
  connected_has_genus (good_wf gd) (good_connected gd) (false, Ordinal n_pos).
by exists (N.of_nat (faces s), N.of_nat g); apply: audit_complete.
Qed.

(* The walk round a hub, as a cyclic list of directed edges.

   Where every face contains the hub a, each face has one side that is opposite to a.  Turning
   about a one meets them one after the other: the walk round the graph that is left without a.
   [link_step s a e f]: the directed edges e and f are opposite to a in two faces that follow one
   another.  [contour s a c]: the cyclic list c is the walk, and no directed edge is met twice.
   Then a face is known by the labels of its corners, and surfaces with the same hub and the
   same walk are the same ([equal_contours]). *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach book equal_books.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Contour.

Variables D V : finType.
Implicit Types (s : surface D V) (a : V) (e f : V * V) (c : seq (V * V)) (x d : D).

(* The directed edge opposite to a in the face of the spoke d, which runs to a, ends where d starts;
   the next one is in the face behind d. *)
Definition link_step s a e f := [exists d,
  [&& origin s (next s d) == a, e == (corner s d, origin s d)
    & f == (origin s d, corner s (twin s d))]].

Definition opposite s a := [set x | corner s x == a].

Definition contour s a c :=
  [/\ uniq c, path.cycle (link_step s a) c & size c = #|opposite s a|].

End Contour.

Section Contour1.

Variables D V : finType.
Variables (s : surface D V) (a : V) (c : seq (V * V)).
Hypothesis wf : well_formed s.
Hypothesis lf : loopless s.
Hypothesis hub_a : hub s a.
Hypothesis con : contour s a c.
Implicit Types x y d : D.

Definition ends x := (origin s x, origin s (next s x)).

Lemma link_step_ends e f : link_step s a e f ->
  exists2 x, corner s x = a & ends x = e.
Proof.
case/existsP => d /and3P[/eqP nd /eqP-> _]; exists (prev s d).
  by rewrite -nd /corner /prev !(next3 wf).
by rewrite /ends (prevK wf).
Qed.

(* The walk meets each face once. *)
Lemma contour_ends : [set e | e \in c] = [set ends x | x in opposite s a] /\
  {in opposite s a &, injective ends}.
Proof.
have [un cyc sz] := con; set E := [set ends x | x in opposite s a].
have sub : [set e | e \in c] \subset E.
  apply/subsetP => e; rewrite inE => e_in; have := next_cycle cyc e_in.
  by case/link_step_ends => x cx <-; apply: imset_f; rewrite inE cx.
have card_c : #|[set e | e \in c]| = size c by rewrite cardsE; apply/card_uniqP.
have card_E : #|E| = #|opposite s a|.
  apply/eqP; rewrite eqn_leq leq_imset_card -sz -card_c; exact: subset_leq_card.
split; last exact/imset_injP/eqP.
by apply/eqP; rewrite eqEcard sub card_E card_c sz leqnn.
Qed.

Lemma opposite_ends x : corner s x = a -> ends x \in c.
Proof.
move=> cx; have [/setP/(_ (ends x)) eq_c _] := contour_ends.
by rewrite inE in eq_c; rewrite eq_c; apply: imset_f; rewrite inE cx.
Qed.

(* Every face has one of its three sides opposite to a. *)
Lemma hub_cases x : [\/ corner s x = a, corner s (next s x) = a | corner s (prev s x) = a].
Proof.
rewrite /corner /prev !(next3 wf); case/or3P: (hub_a x) => /eqP e.
- by constructor 2.
- by constructor 3.
by constructor 1.
Qed.

(* A dart is known by the corners of its face. *)
Lemma contour_corners_inj : injective (corners s).
Proof.
have one x y : corner s x = a -> corners s x = corners s y -> x = y.
  move=> cx [o n cc]; have [_ inj] := contour_ends; apply: inj; rewrite ?inE -?cc ?cx //.
  by rewrite /ends o n.
move=> x y eq_xy; case: (hub_cases x) => cx; first exact: one cx eq_xy.
  apply: (next_inj (s := s)); apply: one cx _; apply/eqP.
  by rewrite -(corners_eq_next _ _ wf wf) eq_xy.
apply: (prev_inj (s := s)); apply: one cx _; apply/eqP.
by rewrite -!(corners_eq_next _ _ wf wf) eq_xy.
Qed.

(* Behind a side opposite to a there is a as well. *)
Lemma corner_opposite x : corner s x = a -> corner s (twin s x) = a.
Proof.
move=> cx; have [_ n2 n3] := corners_differ wf lf x; rewrite cx in n2 n3.
have := hub_a (twin s x); rewrite /at_face (origin_twin wf) (origin_next_twin wf).
by rewrite (negbTE n2) eq_sym (negbTE n3) => /eqP.
Qed.

Lemma link_step_spoke d e f : origin s (next s d) = a -> e = (corner s d, origin s d) ->
  link_step s a e f = (f == (origin s d, corner s (twin s d))).
Proof.
move=> nd def_e; apply/existsP/idP => [[d' /and3P[/eqP nd' /eqP def_e' /eqP->]]|/eqP->]; last first.
  by exists d; rewrite nd def_e !eqxx.
have -> // : d' = d; apply: contour_corners_inj; move: def_e'; rewrite def_e => -[e1 e2].
by rewrite /corners nd nd' e1 e2.
Qed.

Lemma link_step_fun e f f' : link_step s a e f -> link_step s a e f' -> f = f'.
Proof.
by case/existsP => d /and3P[/eqP nd /eqP de /eqP->]; rewrite (link_step_spoke _ nd de) => /eqP.
Qed.

End Contour1.

(* The same hub and the same walk: the same surface. *)
Theorem equal_contours (D D' V : finType) (s : surface D V) (s' : surface D' V) a c :
    well_formed s -> well_formed s' -> loopless s -> loopless s' -> hub s a -> hub s' a ->
    contour s a c -> contour s' a c ->
  same_surface s s'.
Proof.
have faces (D1 D2 : finType) (s1 : surface D1 V) (s2 : surface D2 V) :
    well_formed s1 -> well_formed s2 -> hub s1 a -> contour s1 a c -> contour s2 a c ->
    forall x, exists x', corners s2 x' == corners s1 x.
  move=> wf1 wf2 hub1 con1 con2.
  have one x : corner s1 x = a -> exists x', corners s2 x' == corners s1 x.
    move=> cx; have [/setP/(_ (ends s1 x)) eq_c _] := contour_ends wf2 con2.
    move: eq_c; rewrite inE (opposite_ends wf1 con1 cx) => /esym/imsetP[x'].
    by rewrite inE => /eqP cx' [ox nx]; exists x'; rewrite /corners cx cx' ox nx.
  move=> x; case: (hub_cases wf1 hub1 x) => cx; first exact: one.
    have [y cy] := one _ cx; exists (prev s2 y).
    by rewrite (corners_eq_next _ _ wf2 wf1) prevK.
  have [y cy] := one _ cx; exists (next s2 y).
  by rewrite -{1}(prevK wf1 x) -(corners_eq_next _ _ wf2 wf1).
move=> wf wf' lf lf' hub_a hub_a' con con'.
have [un cyc _] := con; have [_ cyc' _] := con'.
apply: same_by_corners => //.
- exact: contour_corners_inj con.
- exact: contour_corners_inj con'.
- exact: faces con con'.
- exact: faces con' con.
have spoke d d' : origin s (next s d) = a -> corners s' d' = corners s d ->
    corner s' (twin s' d') = corner s (twin s d).
  move=> nd cd; pose e := (corner s d, origin s d).
  have e_in : e \in c.
    have : corner s (prev s d) = a by rewrite -nd /corner /prev !(next3 wf).
    by move/(opposite_ends wf con); rewrite /ends (prevK wf).
  have := next_cycle cyc e_in; rewrite (link_step_spoke wf hub_a con _ nd) // => /eqP def_f.
  have := next_cycle cyc' e_in; rewrite (link_step_spoke wf' hub_a' con' (d := d')).
  - by rewrite def_f => /eqP[].
  - by move: cd => [_ -> _].
  by rewrite /e; have [-> _ ->] := cd.
move=> x x' cx; case/or3P: (hub_a x) => /eqP hx.
- pose d := twin s x; have nd : origin s (next s d) = a by rewrite (origin_next_twin wf).
  pose e := (corner s d, origin s d).
  have e_in : e \in c.
    have : corner s (prev s d) = a by rewrite -nd /corner /prev !(next3 wf).
    by move/(opposite_ends wf con); rewrite /ends (prevK wf).
  have := next_cycle cyc e_in; rewrite (link_step_spoke wf hub_a con _ nd) // => /eqP def_f.
  have := next_cycle cyc' e_in; rewrite def_f.
  case/existsP => d' /and3P[/eqP nd' /eqP[c1 c2] /eqP[_ c4]].
  have -> : x' = twin s' d'.
    apply: (contour_corners_inj wf' hub_a' con'); rewrite cx corners_twin // nd' -c2 -c4.
    by rewrite /d (twinK wf) (origin_twin wf) -hx.
  by rewrite (twinK wf') -c1.
- exact: spoke.
have cx' : corner s' x' = a by have [_ _ ->] := cx.
by rewrite (corner_opposite wf lf hub_a hx) (corner_opposite wf' lf' hub_a' cx').
Qed.

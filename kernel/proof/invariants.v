(* Theorem 4.2: what a flip keeps.

   [theorem_4_2] collects it: a flip of an edge whose opposite corners differ leads from a
   well-formed, loopless, connected surface to another one, with the same numbers of vertices,
   edges and faces (counted as orbits), the same Euler characteristic and genus, and the
   three-neighbour rule.

   [theorem_4_2_guard]: in that class the flip makes no loop exactly where the opposite corners
   differ.  Then the corners after a flip, that the edge may be flipped again, and that [unflip]
   undoes it ([flipK]).  The group of the flip and its locality are in order.v.

   Vertices are counted through permutations: the new sigma is the old one with h taken out of its
   orbit and put before d, and t taken out of its orbit and put before b.  Each of these moves is
   two transpositions, one of which splits an orbit and the other joins two. *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.
From Tightflip Require Import surface flip.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Orbits of a permutation. *)
Section Orbits.

Variable D : finType.
Implicit Types (p : {perm D}) (x y z : D).

Lemma porbits_mul_tpermR p x y :
  #|porbits (p * tperm x y)%g| + (x \notin porbit p y).*2 = #|porbits p| + (x != y).
Proof.
have := porbits_mul_tperm p^-1%g x y.
by rewrite /= porbitV porbitsV -porbitsV invMg invgK tpermV.
Qed.

(* x is taken out of its orbit and put before z. *)
Definition move p x z : {perm D} := (p * tperm x (p x) * tperm x z)%g.

(* Step by step: what came before x now meets what came after it, and what came before z meets x. *)
Lemma moveE p x z y : p x != x -> p x != z -> z != x -> move p x z y =
  if p y == x then p x else if p y == p x then z else if p y == z then x else p y.
Proof.
move=> px pxz zx; rewrite !permM; case: (p y =P x) => [->|/eqP pyx].
  by rewrite tpermL tpermD // eq_sym.
case: (p y =P p x) => [->|/eqP pypx]; first by rewrite tpermR tpermL.
rewrite [tperm x (p x) (p y)]tpermD; try by rewrite eq_sym.
by case: (p y =P z) => [->|/eqP pyz]; rewrite ?tpermR // tpermD // eq_sym.
Qed.

(* That keeps the number of orbits, wherever z is. *)
Lemma porbits_move p x z : p x != x -> z != x -> #|porbits (move p x z)| = #|porbits p|.
Proof.
move=> px zx; have out := porbits_mul_tpermR p x (p x).
rewrite porbit_sym porbit_step (eq_sym x) px /= addn0 in out.
have fix_x : (p * tperm x (p x))%g x = x by rewrite permM tpermR.
have := porbits_mul_tpermR (p * tperm x (p x)) x z.
rewrite (eq_sym x) zx out; have -> : x \notin porbit (p * tperm x (p x))%g z.
  rewrite porbit_sym; apply: contra zx => /porbitP[n ->]; apply/eqP.
  by elim: n => [|n IHn]; rewrite ?expg0 ?perm1 // expgS permM fix_x.
by rewrite -[_ + true + _]addnA => /addIn.
Qed.

(* A label constant on orbits tells them apart when no label is lost and there are as many labels as
   orbits. *)
Lemma labels_tell_orbits (V : finType) p (f : D -> V) :
    (forall x, f (p x) = f x) -> (forall v, exists x, f x = v) -> #|porbits p| = #|V| ->
  forall x y, (f x == f y) = (y \in porbit p x).
Proof.
move=> const used count.
have used_b v : exists x, f x == v by have [x <-] := used v; exists x.
pose rep v := xchoose (used_b v).
have f_rep v : f (rep v) = v by apply/eqP/(xchooseP (used_b v)).
have same x y : y \in porbit p x -> f y = f x by apply: porbit_invariant.
have orbit_inj : injective (fun v => porbit p (rep v)).
  by move=> v w /eqP; rewrite eq_porbit_mem => /same; rewrite !f_rep.
have all_orbits : [set porbit p (rep v) | v in V] = porbits p.
  apply/eqP; rewrite eqEcard; apply/andP; split.
    by apply/subsetP => A /imsetP[v _ ->]; apply: imset_f.
  by rewrite (card_imset _ orbit_inj) count.
have to_rep x : rep (f x) \in porbit p x.
  have : porbit p x \in porbits p by apply: imset_f.
  rewrite -all_orbits => /imsetP[v _ def_x].
  have : x \in porbit p (rep v) by rewrite -def_x porbit_id.
  by move=> /same; rewrite f_rep => ->; rewrite def_x porbit_id.
move=> x y; apply/eqP/idP => [eq_xy|/same //].
have := to_rep y; rewrite -eq_xy porbit_sym; have := to_rep x.
by rewrite -!eq_porbit_mem => /eqP-> /eqP->.
Qed.

End Orbits.

Section Invariants.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Variable h : D.
Hypothesis hap : apart s h.

Let t := twin s h.
Let s' := flip h s.

Let t_neq_h : t != h. Proof. exact: twin_neq. Qed.

(* The six darts differ; the disequalities that are used. *)
Let ne_h : [/\ next s h != h, prev s h != h, next s t != h & prev s t != h].
Proof.
have := quad_uniq wf hap; rewrite /= !inE !negb_or -/t.
by by case/andP=> /and5P[h1 b _ t1 d] _; split; rewrite eq_sym.
Qed.

Let ne_t : [/\ next s h != t, prev s h != t, next s t != t & prev s t != t].
Proof.
have := quad_uniq wf hap; rewrite /= !inE !negb_or -/t.
case/and5P=> _ /and4P[_ h1t _ _] /and3P[bt _ _] /andP[tt1 td] _.
by split; rewrite // eq_sym.
Qed.

(* The faces become (h, b, t1) and (t, d, h1): cycles of length three, without fixed point. *)
Lemma flip_next3 x : next s' (next s' (next s' x)) = x.
Proof.
have [in_q|out] := boolP (x \in quad s h); last first.
  have next_out y : y \notin quad s h -> next s y \notin quad s h.
    by rewrite !quadE // !same_face_next.
  by rewrite !flip_next_out ?next_out // next3.
move: in_q; rewrite !inE.
by case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->];
  do 3!rewrite ?flip_next_self ?flip_next_prev ?flip_next_next_twin
               ?flip_next_twin ?flip_next_prev_twin ?flip_next_next.
Qed.

Lemma flip_next_neq x : next s' x != x.
Proof.
apply/negP => /eqP fixed; have := fixed.
rewrite -[x](permKV (turn s h)) flip_turn => /perm_inj /eqP.
by rewrite (negbTE (next_neq wf _)).
Qed.

(* The new sigma: h is taken out and put before d, then t is taken out and put before b. *)
Lemma flip_sigma : sigma s' = move (move (sigma s) h (prev s t)) t (prev s h).
Proof.
have sigma_h : sigma s h = next s t by rewrite sigmaE.
have E := quad_neqs wf hap; rewrite -/t in E.
have move_h y : move (sigma s) h (prev s t) y =
    if sigma s y == h then next s t else if sigma s y == next s t then prev s t
    else if sigma s y == prev s t then h else sigma s y.
  by rewrite moveE ?sigma_h ?E.
have sigma_t : move (sigma s) h (prev s t) t = next s h.
  by rewrite move_h sigmaE [twin s t](twinK wf) !E.
apply/permP => x; rewrite moveE ?sigma_t ?E // !move_h !sigmaE -[twin s' x]/(twin s x).
move: (twin s x) => y {x}; have [in_q|out] := boolP (y \in quad s h).
  move: in_q; rewrite !inE -/t; case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->].
  - by rewrite flip_next_self // !E eqxx.
  - by rewrite flip_next_next // -/(prev s h) !E eqxx.
  - by rewrite flip_next_prev // prevK // !eqxx !E.
  - by rewrite flip_next_twin // !eqxx !E.
  - by rewrite flip_next_next_twin // -/(prev s t) !eqxx !E.
  - by rewrite flip_next_prev_twin // prevK // !E eqxx.
rewrite flip_next_out //; have: next s y \notin quad s h.
  by rewrite quadE // !same_face_next -quadE.
rewrite !inE !negb_or -/t => /and5P[/negbTE nh /negbTE nh1 /negbTE nb /negbTE nt].
by case/andP=> /negbTE nt1 /negbTE nd; rewrite nh nt1 nd nt nh1 nb.
Qed.

(* The number of vertices, as orbits. *)
Lemma flip_vertices : vertices s' = vertices s.
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
have sigma_h : sigma s h = next s t by rewrite sigmaE.
have sigma_t : move (sigma s) h (prev s t) t = next s h.
  by rewrite moveE ?sigma_h ?E // sigmaE [twin s t](twinK wf) !E.
by rewrite /vertices flip_sigma !porbits_move // ?sigma_h ?sigma_t ?E.
Qed.

(* Labels are constant on the new orbits, *)
Lemma flip_label_sigma x : origin s' (next s' (twin s' x)) = origin s' x.
Proof.
have [h1h bh t1h dh] := ne_h; have [h1t bt t1t dt] := ne_t.
rewrite -[x in RHS](twinK wf) -[twin s' x]/(twin s x); move: (twin s x) => y {x}.
have twin_out z : z != h -> z != t -> origin s' (twin s z) = origin s (next s z).
  move=> zh zt; rewrite flip_origin_out ?origin_twin //.
    by rewrite -(twinK wf h) (inj_eq (@twin_inj _ _ s)).
  by rewrite (inj_eq (@twin_inj _ _ s)).
have [in_q|out] := boolP (y \in quad s h); last first.
  have y_neq_h : y != h by apply: contra out => /eqP->; rewrite !inE eqxx.
  have y_neq_t : y != t by apply: contra out => /eqP->; rewrite !inE eqxx !orbT.
  have ny_neq z : z \in quad s h -> next s y != z.
    by apply: contraL => /eqP<-; rewrite quadE // !same_face_next -quadE.
  by rewrite flip_next_out // twin_out // flip_origin_out ?ny_neq ?inE ?eqxx ?orbT.
have o_h : origin s' h = corner s t := flip_origin_self s h.
have o_t : origin s' t = corner s h := flip_origin_twin wf h.
move: in_q; rewrite !inE -/t.
case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->].
- by rewrite flip_next_self // flip_origin_out //; exact: esym o_t.
- by rewrite flip_next_next // (twin_out (next s h)).
- rewrite flip_next_prev // twin_out // flip_origin_out // prevK //.
  exact: origin_next_twin.
- by rewrite flip_next_twin // flip_origin_out // [twin s t](twinK wf) o_h.
- by rewrite flip_next_next_twin // (twin_out (next s t)).
- rewrite flip_next_prev_twin // twin_out // flip_origin_out // prevK //.
  exact/esym/origin_twin.
Qed.

(* no label is lost, *)
Lemma flip_label_used v : exists x, origin s' x = v.
Proof.
have [h1h bh t1h dh] := ne_h; have [h1t bt t1t dt] := ne_t.
have [x <-] := label_used wf v; case: (x =P h) => [->|/eqP x_neq_h].
  by exists (next s t); rewrite flip_origin_out // origin_next_twin.
case: (x =P t) => [->|/eqP x_neq_t].
  by exists (next s h); rewrite flip_origin_out // /t origin_twin.
by exists x; rewrite flip_origin_out.
Qed.

(* so that they name the new orbits exactly: the flip keeps well-formedness. *)
Theorem flip_well_formed : well_formed s'.
Proof.
split; [exact: (twinK wf)|exact: (twin_neq wf)|exact: flip_next3|exact: flip_next_neq| |].
- apply: labels_tell_orbits; last by rewrite -/(vertices s') flip_vertices vertices_labels.
    by move=> x; rewrite sigmaE flip_label_sigma.
  exact: flip_label_used.
- exact: flip_label_used.
Qed.

Theorem flip_edges : edges s' = edges s. Proof. by []. Qed.

Theorem flip_faces : faces s' = faces s.
Proof.
by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) (faces3 flip_well_formed) (faces3 wf).
Qed.

Theorem flip_euler : euler s' = euler s.
Proof. by rewrite /euler flip_vertices flip_edges flip_faces. Qed.

(* The six darts stay joined, so that what was joined is joined. *)
Lemma flip_connect x y : connect (link s) x y -> connect (link s') x y.
Proof.
have go_twin z : connect (link s') z (twin s z) by apply: connect1; rewrite /link eqxx.
have go z w : next s' z = w -> connect (link s') z w.
  by move=> <-; apply: connect1; rewrite /link eqxx orbT.
have go_b := go _ _ (flip_next_self wf hap).
have go_t1 := go _ _ (flip_next_prev wf hap).
have go_h := go _ _ (flip_next_next_twin wf hap).
have go_d := go _ _ (flip_next_twin wf hap).
have go_h1 := go _ _ (flip_next_prev_twin wf hap).
have go_t := go _ _ (flip_next_next wf hap).
have t_h : connect (link s') t h by rewrite -[X in connect _ _ X](twinK wf h) go_twin.
have h_t : connect (link s') h t := go_twin h.
have h_d := connect_trans h_t go_d; have h_h1 := connect_trans h_d go_h1.
have h_t1 := connect_trans go_b go_t1.
have h1_h := connect_trans go_t t_h; have d_h := connect_trans go_h1 h1_h.
have b_h := connect_trans go_t1 go_h.
have from_h z : z \in quad s h -> connect (link s') h z.
  by rewrite !inE -/t; case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->]; rewrite ?connect0.
have to_h z : z \in quad s h -> connect (link s') z h.
  by rewrite !inE -/t; case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->]; rewrite ?connect0.
apply: connect_sub x y => x y /orP[] /eqP->; first exact: go_twin.
have [in_q|out] := boolP (x \in quad s h); last by apply: go; rewrite flip_next_out.
by apply: connect_trans (to_h _ in_q) (from_h _ _); rewrite quadE // !same_face_next -quadE.
Qed.

Theorem flip_connected : connected s -> connected s'.
Proof. by move=> con x y; apply: flip_connect. Qed.

Theorem flip_sphere : sphere s -> sphere s'.
Proof.
case=> con euler_eq; split; first exact: flip_connected.
by rewrite flip_vertices flip_edges flip_faces.
Qed.

Theorem flip_has_genus g : has_genus s g -> has_genus s' g.
Proof.
case=> con euler_eq; split; first exact: flip_connected.
by rewrite flip_vertices flip_edges flip_faces.
Qed.

(* Loops: the new edge joins the two opposite corners, all other edges keep their ends. *)
Theorem flip_loopless : loopless s -> (loopless s' <-> allowed s h).
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
move=> noloop; split=> [noloop'|ok x].
  have := noloop' h; rewrite flip_next_self // flip_origin_self.
  by rewrite flip_origin_out ?E // eq_sym.
have [in_q|out] := boolP (x \in quad s h); last first.
  have x_neq_h : x != h by apply: contra out => /eqP->; rewrite !inE eqxx.
  have x_neq_t : x != t by apply: contra out => /eqP->; rewrite !inE eqxx !orbT.
  have nx_neq z : z \in quad s h -> next s x != z.
    by apply: contraL => /eqP<-; rewrite quadE // !same_face_next -quadE.
  by rewrite flip_next_out // !flip_origin_out ?nx_neq ?inE ?eqxx ?orbT.
move: in_q; rewrite !inE -/t; case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->].
- by rewrite flip_next_self // flip_origin_self flip_origin_out ?E // eq_sym.
- rewrite flip_next_next // flip_origin_twin // flip_origin_out ?E //.
  exact: noloop (next s h).
- rewrite flip_next_prev // !flip_origin_out ?E // origin_next_twin //.
  by have := noloop (prev s h); rewrite prevK.
- by rewrite flip_next_twin // flip_origin_twin // flip_origin_out ?E.
- rewrite flip_next_next_twin // flip_origin_self flip_origin_out ?E //.
  exact: noloop (next s t).
- rewrite flip_next_prev_twin // !flip_origin_out ?E // -origin_twin // -/t.
  by have := noloop (prev s t); rewrite prevK.
Qed.

End Invariants.

(* The three-neighbour rule.  Where it fails, the face and its one neighbour have all six sides
   glued to each other, so that every vertex is a corner of that face. *)
Section ThreeNeighbour.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Hypothesis con : connected s.

(* A set of darts that no step leaves is everything. *)
Lemma connected_all (a : pred D) x : a x ->
  (forall y, a y -> a (twin s y)) -> (forall y, a y -> a (next s y)) -> forall y, a y.
Proof.
move=> ax tw nx y; have /connectP[p] := con x y.
elim: p x ax => [|z p IHp] x ax /= => [_ ->//|/andP[xz zp] def_y].
by apply: (IHp z) => //; case/orP: xz => /eqP->; [exact: tw | exact: nx].
Qed.

Lemma three_neighbourP x :
    same_face s (twin s x) (twin s (next s x)) -> same_face s (twin s x) (twin s (prev s x)) ->
  forall v, v \in [:: origin s x; origin s (next s x); origin s (prev s x)].
Proof.
move=> f1 f2; set tx := twin s x in f1 f2 *.
have tw_eq y z : (twin s y == twin s z) = (y == z) := inj_eq (@twin_inj _ _ s) y z.
pose front y := [|| y == x, y == next s x | y == prev s x].
have behind y : same_face s tx y -> front (twin s y).
  have to_front z : front z -> front (twin s (twin s z)) by rewrite (twinK wf).
  have fx : front (twin s tx) by apply: to_front; rewrite /front eqxx.
  have fn : front (twin s (twin s (next s x))) by apply: to_front; rewrite /front eqxx orbT.
  have fp : front (twin s (twin s (prev s x))) by apply: to_front; rewrite /front eqxx !orbT.
  move: f1 f2; rewrite !same_faceE // !tw_eq (negbTE (next_neq wf x)) (negbTE (prev_neq wf x)) /=.
  have np : twin s (next s x) != twin s (prev s x) by rewrite tw_eq eq_sym prev_next_neq.
  by case/orP=> /eqP e1 /orP[] /eqP e2; move: np fn fp; rewrite e1 e2 ?eqxx // => _ fn fp;
     case/or3P=> /eqP->.
pose a y := front y || same_face s tx y.
have a_all y : a y.
  apply: (@connected_all a x) => [|z|z]; first by rewrite /a /front eqxx.
    rewrite /a => /orP[|/behind->//].
    by case/or3P=> /eqP->; rewrite ?same_face_refl ?f1 ?f2 orbT.
  by rewrite /a same_face_next /front -!same_faceE // same_face_next.
have front_label y : front y ->
    origin s y \in [:: origin s x; origin s (next s x); origin s (prev s x)].
  by case/or3P=> /eqP->; rewrite !inE eqxx ?orbT.
move=> v; have [y <-] := label_used wf v; case/orP: (a_all y) => [/front_label//|/behind].
move=> fy; rewrite -(twinK wf y) origin_twin //; apply: front_label.
by rewrite /front -same_faceE // same_face_next same_faceE.
Qed.

Theorem many_vertices_three_neighbour : 3 < #|V| -> three_neighbour s.
Proof.
move=> many x; apply/negP => /andP[f1 f2]; move: many; rewrite ltnNge => /negP[].
rewrite cardE; apply: (uniq_leq_size (enum_uniq V) (s2 := [:: origin s x; _; _])) => v _.
exact: three_neighbourP.
Qed.

End ThreeNeighbour.

(* The allowed class (Definition 4.1, for oriented surfaces). *)
Record allowed_class (D V : finType) (s : surface D V) : Prop := AllowedClass {
  class_well_formed : well_formed s;
  class_loopless : loopless s;
  class_connected : connected s;
  class_three_neighbour : three_neighbour s }.

Section Theorem42.

Variables D V : finType.
Implicit Types (s : surface D V) (h : D).

(* The corners of a quadrilateral that may be flipped are four vertices. *)
Lemma allowed_four s h : well_formed s -> loopless s -> allowed s h ->
  uniq [:: origin s h; origin s (next s h); corner s h; corner s (twin s h)].
Proof.
move=> wf noloop ok; have l1 := noloop h; have l2 := noloop (next s h).
have l3 := noloop (prev s h); rewrite prevK // in l3.
have l4 := noloop (prev s (twin s h)); rewrite prevK // origin_twin // in l4.
have l5 := noloop (next s (twin s h)); rewrite origin_next_twin // in l5.
rewrite /= !inE !negb_or l1 [origin s h == _]eq_sym l3 l5 l2 eq_sym l4 /= andbT.
exact: ok.
Qed.

Lemma allowed_four_vertices s h : well_formed s -> loopless s -> allowed s h -> 3 < #|V|.
Proof.
move=> wf noloop ok; rewrite cardE; have four := allowed_four wf noloop ok.
by apply: (uniq_leq_size four) => v _; rewrite mem_enum.
Qed.

(* A flip of an edge whose opposite corners differ keeps the allowed class, the numbers of
   vertices, edges and faces, the Euler characteristic and the genus. *)
Theorem theorem_4_2 s h : allowed_class s -> allowed s h ->
  [/\ allowed_class (flip h s),
      [/\ vertices (flip h s) = vertices s, edges (flip h s) = edges s
        & faces (flip h s) = faces s],
      euler (flip h s) = euler s
    & forall g, has_genus s g -> has_genus (flip h s) g].
Proof.
case=> wf noloop con _ ok; have hap := allowed_apart wf ok.
split; last by move=> g; apply: flip_has_genus.
- have con' := flip_connected wf hap con; have wf' := flip_well_formed wf hap.
  split=> //; first exact/flip_loopless.
  exact: many_vertices_three_neighbour (allowed_four_vertices wf noloop ok).
- by rewrite flip_vertices // flip_edges flip_faces.
- exact: flip_euler.
Qed.

(* Where the opposite corners coincide the flip would make a loop: the guard is exact. *)
Theorem theorem_4_2_guard s h : allowed_class s -> (loopless (flip h s) <-> allowed s h).
Proof. by case=> wf noloop _ _; apply: flip_loopless => //; apply: loopless_apart. Qed.

End Theorem42.

(* The group of one flip. *)
Section Order.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Variable h : D.
Hypothesis hap : apart s h.

Let t := twin s h.
Let s' := flip h s.

(* The corners of the new faces. *)
Lemma flip_prev_self : prev s' h = next s t.
Proof. by rewrite /prev flip_next_self // flip_next_prev. Qed.

Lemma flip_prev_twin : prev s' t = next s h.
Proof. by rewrite /prev flip_next_twin // flip_next_prev_twin. Qed.

Lemma flip_apart : apart s' h.
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
have wf' := flip_well_formed wf hap.
by rewrite /apart same_faceE // flip_prev_self flip_next_self //= !E.
Qed.

(* After the flip the opposite corners are the old ends of the edge. *)
Lemma flip_corner_self : corner s' h = origin s h.
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
by rewrite /corner flip_prev_self flip_originE !E origin_next_twin.
Qed.

Lemma flip_corner_twin : corner s' t = origin s t.
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
by rewrite /corner flip_prev_twin flip_originE !E -origin_twin.
Qed.

Lemma flip_allowed : loopless s -> allowed s' h.
Proof.
move=> noloop; rewrite /allowed flip_corner_self -[twin s' h]/t flip_corner_twin.
by rewrite origin_twin //; apply: noloop.
Qed.

Lemma flip_turned : turn s' h = turn s h.
Proof.
rewrite /turn flip_prev_self flip_next_self // -[twin s' h]/t flip_prev_twin flip_next_twin //.
by rewrite cycle4_rot // turn_uniq.
Qed.

(* Undone exactly, label by label and dart by dart. *)
Theorem flipK : unflip h (flip h s) = s.
Proof.
have E := quad_neqs wf hap; rewrite -/t in E.
apply: surface_eq => [//||] x; first by rewrite /= flip_turned conjgK.
rewrite ffunE -[twin _ h]/t flip_corner_self flip_corner_twin.
case: (x =P h) => [->//|/eqP xh]; case: (x =P t) => [->//|/eqP xt].
by rewrite flip_origin_out.
Qed.

End Order.

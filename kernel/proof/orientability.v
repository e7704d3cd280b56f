(* The flip keeps orientability and its absence, and all the rest of Theorem 4.2, on surfaces
   whose sides may be glued in either direction (signed.v).

   Where the side h is not reversed, the flip is that of flip.v on the underlying table, and no bit
   changes ([straight_flip]).  Where it is reversed, the face behind it is turned over first.
   The number of vertices is that of flip.v's count, used twice on the double cover: there one
   flip is a flip of the one copy of the edge and an inverse flip of the other. *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.
From Tightflip Require Import surface flip invariants order signed.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* A permutation of the sides, on one of the two copies in the cover. *)
Section Lift.

Variable D : finType.
Implicit Types (p q : {perm D}) (e : bool).

Definition lift_fun e p (z : D * bool) := (if z.2 == e then p z.1 else z.1, z.2).

Lemma lift_inj e p : injective (lift_fun e p).
Proof.
case=> x a [y b] [/= eq_xy ab]; move: eq_xy; rewrite -ab.
by case: eqP => [_ /perm_inj|_] ->.
Qed.

Definition lift e p : {perm D * bool} := perm (@lift_inj e p).

Lemma liftE e p z : lift e p z = (if z.2 == e then p z.1 else z.1, z.2).
Proof. by rewrite permE. Qed.

Lemma liftM e p q : lift e (p * q)%g = (lift e p * lift e q)%g.
Proof. by apply/permP => z; rewrite permM !liftE /=; case: eqP; rewrite ?permM. Qed.

Lemma liftV e p : lift e p^-1%g = (lift e p)^-1%g.
Proof.
apply: (mulgI (lift e p)); rewrite -liftM !mulgV; apply/permP => -[x a].
by rewrite liftE !perm1 if_same.
Qed.

Lemma lift_tperm e x y : lift e (tperm x y) = tperm (x, e) (y, e).
Proof.
apply/permP => -[z a]; rewrite liftE /=; case: eqP => [->|neq_e].
  case: tpermP => [->|->|zx zy]; rewrite ?tpermL ?tpermR // tpermD //.
    by apply/eqP => -[/esym].
  by apply/eqP => -[/esym].
by rewrite tpermD //; apply/eqP => -[_ /esym].
Qed.

Lemma lift_cycle4 e x1 x2 x3 x4 :
  lift e (cycle4 x1 x2 x3 x4) = cycle4 (x1, e) (x2, e) (x3, e) (x4, e).
Proof. by rewrite /cycle4 !liftM !lift_tperm. Qed.

End Lift.

(* The flip of an edge whose two sides are not reversed. *)
Definition straight_flip (D V : finType) h (s : signed D V) :=
  Signed (flip h (base s)) (reversed s).

(* The double cover is a surface, with its vertices as labels. *)
Definition cover (D V : finType) (s : signed D V) := named (ctwin s) (cnext s).

Section Cover.

Variables D V : finType.
Variable s : signed D V.
Hypothesis gl : glued s.

Lemma cover_well_formed : well_formed (cover s).
Proof.
case: (gl) => tK t_neq n3 n_neq _; apply: named_well_formed.
- exact: ctwinK.
- by case=> x e; rewrite ctwinE; apply/eqP => -[/= /eqP]; rewrite (negbTE (t_neq x)).
- by case=> x []; rewrite !cnextE /= ?(next_inv gl) /prev !n3.
- case=> x e; rewrite cnextE; apply/eqP => -[/=].
  case: e => /eqP; last by rewrite (negbTE (n_neq x)).
  by rewrite -(inj_eq (@perm_inj _ (next (base s)))) permKV eq_sym (negbTE (n_neq x)).
Qed.

End Cover.

Section StraightFlip.

Variables D V : finType.
Variable s : signed D V.
Hypothesis gl : glued s.
Variable h : D.
Hypothesis hap : apart (base s) h.
Hypothesis straight : reversed s h = false.

Let b := base s.
Let t := twin b h.
Let s' := straight_flip h s.
Let wf0 := named_base_well_formed gl.
Let hap0 : apart (named (twin b) (next b)) h. Proof. exact: hap. Qed.
Let p := turn b h.

Lemma straight_flip_glued : glued s'.
Proof.
split; [exact: (glued_twinK gl)|exact: (glued_twin_neq gl)| | |exact: (reversed_twin gl)].
- exact: (flip_next3 wf0 hap0).
- exact: (flip_next_neq wf0 h).
Qed.

Let c := cover s.
Let wfc : well_formed c := cover_well_formed gl.

Let apart_cover : apart c (h, false).
Proof.
move: hap0; rewrite /apart (same_faceE wf0) (same_faceE wfc); apply: contra.
rewrite /= ctwinE /= straight /= /prev /= !cnextE /= !xpair_eqE !andbT; exact: id.
Qed.

(* The first copy of the edge is flipped as it stands, *)
Let cnext_false x : cnext s (x, false) = (next b x, false). Proof. by rewrite cnextE. Qed.
Let cnext_true x : cnext s (x, true) = (prev b x, true).
Proof. by rewrite cnextE /= (next_inv gl). Qed.
Let ctwin_h e : ctwin s (h, e) = (t, e). Proof. by rewrite ctwinE /= straight addbF. Qed.

Let turn_cover : turn c (h, false) = lift false p.
Proof. by rewrite /p /turn lift_cycle4 /prev /= ctwin_h !cnext_false. Qed.

Let c1 := flip (h, false) c.
Let wf1 : well_formed c1. Proof. exact: flip_well_formed. Qed.

Let c1_next : next c1 = (cnext s ^ lift false p)%g. Proof. by rewrite /= turn_cover. Qed.

Let c1_next_true x : next c1 (x, true) = (prev b x, true).
Proof.
have fixed y : lift false p (y, true) = (y, true) by rewrite liftE.
by rewrite c1_next -{1}(fixed x) permJ cnext_true fixed.
Qed.

Let b3 x : next b (next b (next b x)) = x. Proof. exact: (glued_next3 gl). Qed.

Let c1_prev_true x : prev c1 (x, true) = (next b x, true).
Proof. by rewrite /prev !c1_next_true /prev b3. Qed.

Let apart_cover1 : apart c1 (h, true).
Proof.
move: hap0; rewrite /apart (same_faceE wf0) (same_faceE wf1); apply: contra.
rewrite c1_prev_true c1_next_true [twin c1 _]ctwin_h !xpair_eqE !andbT.
by case/or3P=> ->; rewrite ?orbT.
Qed.

(* and the second copy, where the faces run the other way, is turned the other way. *)
Let turn_inverse : cycle4 (prev b h) (next b h) (prev b t) (next b t) = (p^-1)%g.
Proof.
have un : uniq [:: next b h; prev b h; next b t; prev b t] := turn_uniq wf0 hap0.
have un' : uniq [:: prev b h; next b h; prev b t; next b t].
  move: un; rewrite /= !inE !negb_or -!andbA.
  case/and5P=> n12 n13 n14 n23 /and3P[n24 n34 _].
  by rewrite eq_sym n12 n24 n23 n14 n13 eq_sym n34.
apply: (mulgI p); rewrite mulgV; apply/permP => x; rewrite permM perm1.
have [in_x | out] := boolP (x \in [:: next b h; prev b h; next b t; prev b t]); last first.
  rewrite /p /turn (cycle4_out out) cycle4_out //; move: out.
  by rewrite !inE !negb_or => /and4P[-> -> -> ->].
move: in_x; rewrite !inE /p /turn => /or4P[] /eqP->.
- by rewrite (cycle4_1 un) (cycle4_1 un').
- by rewrite (cycle4_2 un) (cycle4_4 un').
- by rewrite (cycle4_3 un) (cycle4_3 un').
- by rewrite (cycle4_4 un) (cycle4_2 un').
Qed.

Let turn_cover1 : turn c1 (h, true) = lift true (p^-1)%g.
Proof.
by rewrite -turn_inverse lift_cycle4 /turn [twin c1 _]ctwin_h !c1_prev_true !c1_next_true.
Qed.

Let cnext_flip : cnext s' = next (unflip (h, true) c1).
Proof.
rewrite -[RHS]/(next c1 ^ (turn c1 (h, true))^-1)%g c1_next turn_cover1 liftV invgK -conjgM.
have lifts z : (lift false p * lift true p)%g z = (p z.1, z.2).
  by case: z => x []; rewrite permM !liftE.
apply/permP => w; rewrite -[w](permKV (lift false p * lift true p)%g) permJ.
move: (_ w) => [x e]; rewrite !lifts cnextE /=; case: e; rewrite /= ?cnext_true ?cnext_false /=.
  by rewrite -conjVg permJ (next_inv gl).
by rewrite permJ.
Qed.

Lemma straight_flip_count : #|porbits (csigma s')| = #|porbits (csigma s)|.
Proof.
have -> : csigma s' = sigma (unflip (h, true) c1).
  rewrite /csigma cnext_flip /sigma; congr (_ * _)%g.
  by apply/permP => z; rewrite /= !ctwinE.
have hap1 : apart c1 (h, true) := apart_cover1.
rewrite -/(vertices _) (unflip_flip3 wf1 hap1).
have wf2 := flip_well_formed wf1 hap1; have hap2 := flip_apart wf1 hap1.
have wf3 := flip_well_formed wf2 hap2; have hap3 := flip_apart wf2 hap2.
by rewrite (flip_vertices wf3 hap3) (flip_vertices wf2 hap2) (flip_vertices wf1 hap1) flip_vertices.
Qed.

(* The sides that are not flipped keep their ends. *)
Let ne_h : [/\ next b h != h, prev b h != h, next b t != h & prev b t != h].
Proof.
have := quad_uniq wf0 hap0; rewrite /quad /= !inE !negb_or -!andbA.
case/and5P=> n01 n02 n03 n04; case/and5P=> n05 n12 n13 n14 _.
by split; rewrite eq_sym.
Qed.

Let ne_t : [/\ next b h != t, prev b h != t, next b t != t & prev b t != t].
Proof.
have := quad_uniq wf0 hap0; rewrite /quad /= !inE !negb_or -!andbA.
case/and5P=> n01 n02 n03 n04; case/and5P=> n05 n12 n13 n14; case/and5P=> n15 n23 n24 n25.
by case/and3P=> n34 n35 n45; split; rewrite // eq_sym.
Qed.

Let b' := base s'.
Let new_h : next b' h = prev b h := flip_next_self wf0 hap0.
Let new_t : next b' t = prev b t := flip_next_twin wf0 hap0.
Let new_h1 : next b' (next b h) = t := flip_next_next wf0 hap0.
Let new_b : next b' (prev b h) = next b t := flip_next_prev wf0 hap0.
Let new_t1 : next b' (next b t) = h := flip_next_next_twin wf0 hap0.
Let new_d : next b' (prev b t) = next b h := flip_next_prev_twin wf0 hap0.
Let new_out x (out : x \notin quad b h) : next b' x = next b x :=
  flip_next_out wf0 (out : x \notin quad (named (twin b) (next b)) h).
Let new_origin x : x != h -> x != t -> origin b' x = origin b x.
Proof. by move=> /negbTE xh /negbTE xt; rewrite ffunE xh xt. Qed.
Let new_origin_h : origin b' h = corner b t. Proof. by rewrite ffunE eqxx. Qed.
Let new_origin_t : origin b' t = corner b h.
Proof. by rewrite ffunE eqxx (negbTE (glued_twin_neq gl h)). Qed.

(* Which faces to turn over need not change: both faces beside the edge go the same way. *)
Lemma straight_flip_orientable : orientable s' <-> orientable s.
Proof.
split=> -[o [o_next o_twin]]; exists o; split=> // x;
  have oth := o_twin h; rewrite straight addbF in oth.
  have step y z : next b' y = z -> o z = o y by move=> <-; apply: o_next.
  have ob := step _ _ new_h; have ot1 := step _ _ new_b; have od := step _ _ new_t.
  have oh1 := step _ _ new_d; rewrite -/t in oth.
  have [in_q | out] := boolP (x \in quad b h); last by rewrite -new_out // o_next.
  move: in_q; rewrite !inE; case/or3P=> [/eqP->|/eqP->|/or4P[] /eqP->]; rewrite /prev ?b3.
  - by rewrite oh1 od oth.
  - by rewrite -/(prev b h) ob oh1 od oth.
  - by rewrite -/(prev b h) ob.
  - by rewrite -/t ot1 ob oth.
  - by rewrite -/t -/(prev b t) od ot1 ob oth.
  by rewrite -/t -/(prev b t) od.
have [in_q | out] := boolP (x \in quad b h); last by rewrite new_out // o_next.
move: in_q; rewrite !inE; case/or3P=> [/eqP->|/eqP->|/or4P[] /eqP->].
- by rewrite new_h /prev !o_next.
- by rewrite new_h1 o_next.
- by rewrite new_b /prev !o_next.
- by rewrite new_t /prev !o_next.
- by rewrite new_t1 o_next.
by rewrite new_d /prev !o_next.
Qed.

Lemma straight_flip_connected : connected b -> connected b'.
Proof. exact: (flip_connected wf0 hap0). Qed.

Hypothesis ends : ends_match s.

Let ends_h : origin b t = origin b (next b h) /\ origin b (next b t) = origin b h.
Proof. by have := ends h; rewrite straight. Qed.

Let side_ends y : y != h -> y != t ->
  origin b' y = origin b y /\ origin b' (next b' y) = origin b (next b y).
Proof.
move=> yh yt; split; first exact: new_origin.
have [h1h bh t1h dh] := ne_h; have [h1t bt t1t dt] := ne_t; have [e1 e2] := ends_h.
have [in_q | out] := boolP (y \in quad b h); last first.
  rewrite new_out // new_origin //.
    by apply: contra out => /eqP e; rewrite -(b3 y) e !inE eqxx ?orbT.
  by apply: contra out => /eqP e; rewrite -(b3 y) e !inE -/t eqxx !orbT.
move: in_q; rewrite !inE (negbTE yh) (negbTE yt) /=; case/or4P=> /eqP->.
- by rewrite new_h1 new_origin_t.
- by rewrite new_b new_origin // e2 /prev b3.
- by rewrite new_t1 new_origin_h.
- by rewrite new_d new_origin // -e1 /prev b3.
Qed.

Lemma straight_flip_ends : ends_match s'.
Proof.
have [h1h bh t1h dh] := ne_h; have [h1t bt t1t dt] := ne_t.
have tK := glued_twinK gl; have straight_t : reversed s t = false.
  by rewrite (reversed_twin gl).
move=> x; have [-> | xh] := eqVneq x h.
  by rewrite straight -[twin _ h]/t new_origin_t new_origin_h new_h new_t !new_origin.
have [-> | xt] := eqVneq x t.
  by rewrite straight_t [twin _ t]tK new_origin_t new_origin_h new_h new_t !new_origin.
have txh : twin b x != h by apply: contra xt => /eqP e; rewrite /t -e tK.
have txt : twin b x != t by apply: contra xh => /eqP /(can_inj tK) ->.
have [e1 e2] := side_ends xh xt; have [f1 f2] := side_ends txh txt.
by rewrite -[twin _ x]/(twin b x) -/b' e1 e2 f1 f2; apply: ends.
Qed.

(* Loops: only the new edge could be one. *)
Lemma straight_flip_loopless : loopless b -> (loopless b' <-> allowed b h).
Proof.
have [h1h bh t1h dh] := ne_h; have [h1t bt t1t dt] := ne_t.
move=> lf; split=> [lf' | al x].
  by have := lf' h; rewrite new_h new_origin_h new_origin // eq_sym.
have [-> | xh] := eqVneq x h; first by rewrite new_h new_origin_h new_origin // eq_sym.
have [-> | xt] := eqVneq x t; first by rewrite new_t new_origin_t new_origin.
by have [-> ->] := side_ends xh xt; apply: lf.
Qed.

(* No label is lost. *)
Lemma straight_flip_used :
  (forall v, exists x, origin b x = v) -> forall v, exists x, origin b' x = v.
Proof.
move=> used v; have [x <-] := used v; have [e1 e2] := ends_h.
have [h1h _ t1h _] := ne_h; have [h1t _ t1t _] := ne_t.
have [-> | xh] := eqVneq x h; first by exists (next b t); rewrite new_origin.
have [-> | xt] := eqVneq x t; first by exists (next b h); rewrite new_origin.
by exists x; rewrite new_origin.
Qed.

End StraightFlip.

(* So the flip of an edge that is not reversed keeps well-formedness. *)
Theorem straight_flip_well_formed (D V : finType) (s : signed D V) h :
    signed_well_formed s -> apart (base s) h -> reversed s h = false ->
  signed_well_formed (straight_flip h s).
Proof.
case=> gl label used hap straight; have constant z : clabel s (csigma s z) = clabel s z.
  by apply/esym/eqP; rewrite label; have := mem_porbit (csigma s) 1 z; rewrite expg1 => ->.
have ends := (constant_ends s).1 constant.
have gl' := straight_flip_glued gl hap; have ends' := straight_flip_ends gl hap straight ends.
have used' := straight_flip_used gl hap straight ends used.
split=> //; apply: (label_count gl' _ used').1; first exact/constant_ends.
by rewrite straight_flip_count // (label_count gl constant used).2.
Qed.

(* The flip: where the sides of the edge are reversed, the face behind it is turned over first. *)
Definition straightened (D V : finType) h (s : signed D V) :=
  if reversed s h then turn_over (twin (base s) h) s else s.
Definition signed_flip (D V : finType) h (s : signed D V) := straight_flip h (straightened h s).

(* The Euler characteristic. *)
Definition signed_euler (D V : finType) (s : signed D V) : int :=
  ((signed_vertices s)%:Z - (edges (base s))%:Z + (faces (base s))%:Z)%R.

Section SignedFlip.

Variables D V : finType.
Implicit Types (s : signed D V) (h : D).

Lemma well_formed_ends s : signed_well_formed s -> ends_match s.
Proof.
case=> _ label _; apply: (constant_ends s).1 => z; apply/esym/eqP; rewrite label.
by have := mem_porbit (csigma s) 1 z; rewrite expg1 => ->.
Qed.

(* The faces beside an edge whose opposite corners differ are two. *)
Lemma signed_allowed_apart s h : signed_well_formed s -> allowed (base s) h -> apart (base s) h.
Proof.
move=> wf al; have [gl _ _] := wf; have [e1 e2] := well_formed_ends wf h.
have b3 := glued_next3 gl; set b := base s in al e1 e2 b3 *.
rewrite /apart (glued_same_face gl); apply/negP => /or3P[|/eqP th|/eqP th].
- by rewrite (negbTE (glued_twin_neq gl h)).
- move: al; rewrite /allowed /corner th /prev b3; move: e1 e2; rewrite th.
  by case: (reversed s h) => [e1 e2|_ ->]; rewrite ?eqxx // e2 e1 eqxx.
- move: al; rewrite /allowed /corner th /prev b3; move: e1 e2; rewrite th /prev b3.
  by case: (reversed s h) => [-> <-|->]; rewrite eqxx.
Qed.

Lemma straightened_not_reversed s h : glued s -> apart (base s) h ->
  reversed (straightened h s) h = false.
Proof.
move=> gl hap; rewrite /straightened; case: ifP => // rev; rewrite turned_reversed rev.
by rewrite same_face_refl same_face_sym (negbTE hap).
Qed.

Lemma straightened_well_formed s h : signed_well_formed s -> signed_well_formed (straightened h s).
Proof.
move=> wf; rewrite /straightened; case: ifP => // _.
by apply: turn_over_well_formed => //; case: wf.
Qed.

Lemma straightened_apart s h : glued s -> apart (base (straightened h s)) h = apart (base s) h.
Proof. by move=> gl; rewrite /straightened; case: ifP => // _; apply: turn_over_apart. Qed.

Lemma straightened_allowed s h : glued s ->
  allowed (base (straightened h s)) h = allowed (base s) h.
Proof. by move=> gl; rewrite /straightened; case: ifP => // _; apply: turn_over_allowed. Qed.

Lemma signed_vertices_labels s : signed_well_formed s -> signed_vertices s = #|V|.
Proof.
move=> wf; have [gl label used] := wf; have ends := well_formed_ends wf.
by rewrite /signed_vertices (label_count gl _ used).2 ?mul2n ?doubleK //; apply/constant_ends.
Qed.

Lemma signed_faces s : glued s -> faces (base s) * 3 = #|D|.
Proof. by move=> gl; apply: (faces3 (named_base_well_formed gl)). Qed.

(* The flip keeps well-formedness. *)
Theorem signed_flip_well_formed s h : signed_well_formed s -> apart (base s) h ->
  signed_well_formed (signed_flip h s).
Proof.
move=> wf hap; have [gl _ _] := wf; apply: straight_flip_well_formed.
- exact: straightened_well_formed.
- by rewrite straightened_apart.
exact: straightened_not_reversed.
Qed.

(* Orientable before exactly where orientable after. *)
Theorem signed_flip_orientable s h : signed_well_formed s -> apart (base s) h ->
  orientable (signed_flip h s) <-> orientable s.
Proof.
move=> wf hap; have [gl _ _] := wf; have [gl1 _ _] := straightened_well_formed h wf.
have straight := straightened_not_reversed gl hap.
have hap1 : apart (base (straightened h s)) h by rewrite straightened_apart.
apply: iff_trans (straight_flip_orientable gl1 hap1 straight) _.
by rewrite /straightened; case: ifP => // _; apply: turn_over_orientable.
Qed.

(* The three-neighbour rule.  Where it fails, the face and its one neighbour are all there is, so
   that every vertex is a corner of that face. *)
Lemma two_faces s x : glued s -> connected (base s) ->
    same_face (base s) (twin (base s) x) (twin (base s) (next (base s) x)) ->
    same_face (base s) (twin (base s) x) (twin (base s) (prev (base s) x)) ->
  forall y, same_face (base s) x y || same_face (base s) x (twin (base s) y).
Proof.
move=> gl con; set b := base s in con *; set tx := twin b x => f1 f2.
have wf0 := named_base_well_formed gl; have tK := glued_twinK gl.
have tw_eq y z : (twin b y == twin b z) = (y == z) := inj_eq (@perm_inj _ (twin b)) y z.
have n_neq : next b x != x := glued_next_neq gl x.
have p_neq : prev b x != x := prev_neq wf0 x.
have pn_neq : prev b x != next b x := prev_next_neq wf0 x.
have behind : [set tx; twin b (next b x); twin b (prev b x)] = porbit (next b) tx.
  apply/eqP; rewrite eqEcard (card_face wf0); apply/andP; split.
    by apply/subsetP => y; rewrite !inE => /orP[/orP[]|] /eqP-> //; apply: porbit_id.
  rewrite setUC cardsU1 cards2 !inE !tw_eq (negbTE p_neq) (negbTE pn_neq).
  by rewrite [x == _]eq_sym n_neq.
have face_x y : same_face b x (next b y) = same_face b x y := same_face_next _ _ _.
have fx : same_face b x x := same_face_refl _ _.
apply: (connected_all con (a := fun y => same_face b x y || same_face b x (twin b y)) (x := x)).
- by rewrite /= fx.
- by move=> y; rewrite tK orbC.
move=> y /orP[|ty]; first by rewrite face_x => ->.
have ty' : same_face b tx (next b y).
  rewrite same_face_next /same_face -behind -(tK y) !inE !tw_eq -orbA.
  by rewrite -(glued_same_face gl).
have: next b y \in porbit (next b) tx := ty'; rewrite -behind !inE.
by case/orP=> [/orP[]|] /eqP->; rewrite tK ?face_x ?fx ?orbT.
Qed.

Theorem signed_three_neighbour s : signed_well_formed s -> connected (base s) -> 3 < #|V| ->
  three_neighbour (base s).
Proof.
move=> wf con many x; have [gl _ used] := wf; apply/negP => /andP[f1 f2].
have all_faces := two_faces gl con f1 f2; have ends := well_formed_ends wf; move: many.
set b := base s in f1 f2 all_faces ends *.
set cs := [:: origin b x; origin b (next b x); origin b (prev b x)].
have b3 : forall y, next b (next b (next b y)) = y := glued_next3 gl.
have front y : same_face b x y -> (origin b y \in cs) && (origin b (next b y) \in cs).
  by rewrite (glued_same_face gl) !inE => /or3P[] /eqP->; rewrite /prev ?b3 !eqxx ?orbT.
rewrite ltnNge => /negP[]; rewrite cardE; apply: (uniq_leq_size (enum_uniq V) (s2 := cs)) => v _.
have [y <-] := used v; case/orP: (all_faces y) => /front /andP[y_in ny_in] //.
have [e1 e2] := ends (twin b y); rewrite -/b (glued_twinK gl) in e1.
by rewrite e1; case: (reversed _ _).
Qed.

(* The corners of a quadrilateral that may be flipped are four vertices. *)
Lemma signed_four_vertices s h : signed_well_formed s -> loopless (base s) ->
  allowed (base s) h -> 3 < #|V|.
Proof.
move=> wf lf al; have [gl _ _] := wf; have [e1 e2] := well_formed_ends wf h.
have b3 : forall y, next (base s) (next (base s) (next (base s) y)) = y := glued_next3 gl.
have differ x : [/\ origin (base s) x != origin (base s) (next (base s) x),
    corner (base s) x != origin (base s) x &
    corner (base s) x != origin (base s) (next (base s) x)].
  split; [exact: lf | | by rewrite eq_sym; apply: (lf (next (base s) x))].
  by have := lf (prev (base s) x); rewrite /corner /prev b3.
have [n1 n2 n3] := differ h; have [_ m2 m3] := differ (twin (base s) h); rewrite e1 e2 in m2 m3.
have [k2 k3] : corner (base s) (twin (base s) h) != origin (base s) h /\
    corner (base s) (twin (base s) h) != origin (base s) (next (base s) h).
  by move: m2 m3; case: (reversed s h).
pose vs := [:: corner (base s) (twin (base s) h); corner (base s) h; origin (base s) h;
  origin (base s) (next (base s) h)].
rewrite cardE; apply: (@leq_trans (size vs)) => //.
apply: uniq_leq_size => [|v _]; last by rewrite mem_enum.
have al' : corner (base s) (twin (base s) h) != corner (base s) h by rewrite eq_sym.
by rewrite /= !inE !negb_or k2 k3 n2 n3 n1 al'.
Qed.

(* The allowed class (Definition 4.1), orientable or not. *)
Record signed_class s : Prop := SignedClass {
  signed_class_well_formed : signed_well_formed s;
  signed_class_loopless : loopless (base s);
  signed_class_connected : connected (base s);
  signed_class_three_neighbour : three_neighbour (base s) }.

(* What the flip keeps, in one statement; of loops only the new edge could be one. *)
Theorem theorem_4_2_signed s h : signed_class s -> allowed (base s) h ->
  [/\ signed_class (signed_flip h s),
      [/\ signed_vertices (signed_flip h s) = signed_vertices s,
          edges (base (signed_flip h s)) = edges (base s) &
          faces (base (signed_flip h s)) = faces (base s)],
      signed_euler (signed_flip h s) = signed_euler s &
      orientable (signed_flip h s) <-> orientable s].
Proof.
case=> wf lf con _ al; have hap := signed_allowed_apart wf al; have [gl _ _] := wf.
have wf1 := straightened_well_formed h wf; have [gl1 _ used1] := wf1.
have straight := straightened_not_reversed gl hap.
have hap1 : apart (base (straightened h s)) h by rewrite straightened_apart.
have wf2 := signed_flip_well_formed wf hap.
have [gl2 _ _] := wf2.
have eq_v : signed_vertices (signed_flip h s) = signed_vertices s.
  by rewrite !signed_vertices_labels.
have eq_e : edges (base (signed_flip h s)) = edges (base s).
  by rewrite /signed_flip /straightened; case: ifP.
have eq_f : faces (base (signed_flip h s)) = faces (base s).
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) !signed_faces.
have con2 : connected (base (signed_flip h s)).
  apply: (straight_flip_connected gl1 hap1).
  by rewrite /straightened; case: ifP => // _; apply/turn_over_connected.
split=> //; last exact: signed_flip_orientable; last by rewrite /signed_euler eq_v eq_e eq_f.
split=> //; last exact: signed_three_neighbour (signed_four_vertices wf lf al).
apply/(straight_flip_loopless gl1 hap1 straight (well_formed_ends wf1)).
  by rewrite /straightened; case: ifP => // _; apply/turn_over_loopless.
by rewrite straightened_allowed.
Qed.

(* Where the guard fails the flip would make a loop. *)
Theorem signed_flip_guard s h : signed_well_formed s -> apart (base s) h -> loopless (base s) ->
  (loopless (base (signed_flip h s)) <-> allowed (base s) h).
Proof.
move=> wf hap lf; have [gl _ _] := wf.
have wf1 := straightened_well_formed h wf; have [gl1 _ _] := wf1.
have straight := straightened_not_reversed gl hap.
have hap1 : apart (base (straightened h s)) h by rewrite straightened_apart.
rewrite -(straightened_allowed _ gl).
apply: (straight_flip_loopless gl1 hap1 straight (well_formed_ends wf1)).
by rewrite /straightened; case: ifP => // _; apply/turn_over_loopless.
Qed.

End SignedFlip.

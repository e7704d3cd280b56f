(* The flip of an edge, and what it does to each dart.

   With t = twin h, let the faces beside the edge be (h, h1, b) and (t, t1, d).  The flip keeps
   twin, conjugates next by the 4-cycle h1 -> b -> t1 -> d -> h1 ([turn]), and rewrites two labels:
   h starts where d does, t where b does.  The new faces are (h, b, t1) and (t, d, h1).

   Everything here asks only that h and t lie in different faces ([apart]), which holds in every
   surface without loops and wherever the flip is allowed.  The four outer darts may be glued to
   each other in any way: no case distinction is needed.

   The flip is the same from both sides of the edge ([flip_other_side]). *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* The 4-cycle a -> b -> c -> d -> a. *)
Definition cycle4 (D : finType) (a b c d : D) : {perm D} :=
  (tperm a b * tperm a c * tperm a d)%g.

Section Cycle4.

Variable D : finType.
Variables a b c d : D.
Hypothesis abcd : uniq [:: a; b; c; d].

Let differ : [/\ a != b, a != c & a != d] /\ [/\ b != c, b != d & c != d].
Proof.
move: abcd; rewrite /= !inE !negb_or -!andbA.
by case/and5P=> ab ac ad bc /and3P[bd cd _]; do !split.
Qed.

Lemma cycle4_1 : cycle4 a b c d a = b.
Proof.
have [[ab _ _] [bc bd _]] := differ.
by rewrite !permM tpermL [tperm a c b]tpermD // ?[tperm a d b]tpermD // eq_sym.
Qed.

Lemma cycle4_2 : cycle4 a b c d b = c.
Proof.
have [[_ ac _] [_ _ cd]] := differ.
by rewrite !permM tpermR tpermL tpermD // eq_sym.
Qed.

Lemma cycle4_3 : cycle4 a b c d c = d.
Proof.
have [[_ ac _] [bc _ _]] := differ.
by rewrite !permM [tperm a b c]tpermD // tpermR tpermL.
Qed.

Lemma cycle4_4 : cycle4 a b c d d = a.
Proof.
have [[_ _ ad] [_ bd cd]] := differ.
by rewrite !permM [tperm a b d]tpermD // [tperm a c d]tpermD // tpermR.
Qed.

Lemma cycle4_out x : x \notin [:: a; b; c; d] -> cycle4 a b c d x = x.
Proof.
rewrite !inE !negb_or => /and4P[xa xb xc xd].
by rewrite !permM [tperm a b x]tpermD ?[tperm a c x]tpermD ?[tperm a d x]tpermD // eq_sym.
Qed.

End Cycle4.

(* It may be written from any of its four elements. *)
Lemma cycle4_rot (D : finType) (a b c d : D) :
  uniq [:: a; b; c; d] -> cycle4 b c d a = cycle4 a b c d.
Proof.
move=> abcd; have bcda : uniq [:: b; c; d; a] by rewrite -(rot_uniq 1) in abcd *.
apply/permP => x; case in_x: (x \in [:: a; b; c; d]).
  move: in_x; rewrite !inE => /or4P[] /eqP->.
  - by rewrite cycle4_1 // cycle4_4.
  - by rewrite cycle4_2 // cycle4_1.
  - by rewrite cycle4_3 // cycle4_2.
  - by rewrite cycle4_4 // cycle4_3.
by rewrite !cycle4_out ?in_x // -(mem_rot 3) /= in_x.
Qed.

(* The same surface with every dart x called p x. *)
Definition rename (D V : finType) (p : {perm D}) (s : surface D V) : surface D V :=
  Surface (twin s ^ p)%g (next s ^ p)%g [ffun x => origin s (p^-1%g x)].

Section Flip.

Variables D V : finType.
Implicit Types (s : surface D V) (h x : D).

(* h and its twin lie in different faces. *)
Definition apart s h := ~~ same_face s h (twin s h).

Definition turn s h : {perm D} :=
  cycle4 (next s h) (prev s h) (next s (twin s h)) (prev s (twin s h)).

Definition flip h s : surface D V :=
  Surface (twin s) (next s ^ turn s h)%g
    [ffun x => if x == h then corner s (twin s h)
               else if x == twin s h then corner s h else origin s x].

(* The exact inverse: it turns the edge the other way. *)
Definition unflip h s : surface D V :=
  Surface (twin s) (next s ^ (turn s h)^-1)%g
    [ffun x => if x == h then corner s h
               else if x == twin s h then corner s (twin s h) else origin s x].

(* The six darts of the two faces beside h. *)
Definition quad s h : seq D :=
  [:: h; next s h; prev s h; twin s h; next s (twin s h); prev s (twin s h)].

End Flip.

Section Action.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Implicit Types h x : D.

(* The two faces beside an edge differ where the flip is allowed, and where there are no loops. *)
Lemma allowed_apart h : allowed s h -> apart s h.
Proof.
rewrite /apart same_faceE //; apply: contra => /or3P[|/eqP tw|/eqP tw].
- by rewrite (negbTE (twin_neq wf h)).
- by rewrite tw /corner /prev (next3 wf) -(origin_next_twin wf h) tw.
- by rewrite tw /corner /prev (next3 wf) -(origin_twin wf h) tw.
Qed.

Lemma loopless_apart h : loopless s -> apart s h.
Proof.
move=> noloop; rewrite /apart same_faceE //; apply/negP => /or3P[|/eqP tw|/eqP tw].
- by rewrite (negbTE (twin_neq wf h)).
- have := noloop (prev s h); rewrite prevK // -(origin_next_twin wf h) tw.
  by rewrite -/(prev s h) eqxx.
- have := noloop (next s h); rewrite -(origin_twin wf h) tw.
  by rewrite -/(prev s h) eqxx.
Qed.

Variable h : D.
Hypothesis hap : apart s h.

Let t := twin s h.

Lemma face_uniq x : uniq [:: x; next s x; prev s x].
Proof.
by rewrite /= !inE negb_or (next_neq' wf) (prev_neq' wf) eq_sym (prev_next_neq wf).
Qed.

Lemma quad_uniq : uniq (quad s h).
Proof.
rewrite (cat_uniq [:: h; next s h; prev s h] [:: t; next s t; prev s t]) !face_uniq andbT.
apply: contra hap => /hasP[x]; rewrite /= !mem_seq3 -!same_faceE // => tx hx.
by rewrite (same_face_trans hx) // same_face_sym.
Qed.

(* All fifteen disequalities of the six darts, both ways round, as a rule to rewrite with. *)
Lemma quad_neqs :
 (((h == next s h) = false) * ((h == prev s h) = false) * ((h == t) = false) *
  ((h == next s t) = false) * ((h == prev s t) = false) * ((next s h == h) = false) *
  ((next s h == prev s h) = false) * ((next s h == t) = false) * ((next s h == next s t) = false) *
  ((next s h == prev s t) = false) * ((prev s h == h) = false) * ((prev s h == next s h) = false) *
  ((prev s h == t) = false) * ((prev s h == next s t) = false) * ((prev s h == prev s t) = false) *
  ((t == h) = false) * ((t == next s h) = false) * ((t == prev s h) = false) *
  ((t == next s t) = false) * ((t == prev s t) = false) * ((next s t == h) = false) *
  ((next s t == next s h) = false) * ((next s t == prev s h) = false) * ((next s t == t) = false) *
  ((next s t == prev s t) = false) * ((prev s t == h) = false) * ((prev s t == next s h) = false) *
  ((prev s t == prev s h) = false) * ((prev s t == t) = false) *
  ((prev s t == next s t) = false))%type.
Proof.
have := quad_uniq; rewrite /= !inE !negb_or -!andbA andbT -/t.
case/and5P=> n01 n02 n03 n04; case/and5P=> n05 n12 n13 n14; case/and5P=> n15 n23 n24 n25.
case/and3P=> n34 n35 n45.
by do !split; apply/negbTE => //; rewrite eq_sym.
Qed.

(* Outside the quadrilateral means in neither of the two faces. *)
Lemma quadE x : (x \in quad s h) = same_face s h x || same_face s t x.
Proof. by rewrite !same_faceE // !inE -!orbA. Qed.

Lemma turn_uniq : uniq [:: next s h; prev s h; next s t; prev s t].
Proof.
apply: subseq_uniq quad_uniq.
exact: (mask_subseq [:: false; true; true; false; true; true] (quad s h)).
Qed.

Lemma turn_next : turn s h (next s h) = prev s h.
Proof. exact: cycle4_1 turn_uniq. Qed.

Lemma turn_prev : turn s h (prev s h) = next s t.
Proof. exact: cycle4_2 turn_uniq. Qed.

Lemma turn_next_twin : turn s h (next s t) = prev s t.
Proof. exact: cycle4_3 turn_uniq. Qed.

Lemma turn_prev_twin : turn s h (prev s t) = next s h.
Proof. exact: cycle4_4 turn_uniq. Qed.

Lemma turn_out x : x \notin quad s h -> turn s h x = x.
Proof.
rewrite !inE !negb_or => /and5P[_ xh1 xb _ /andP[xt1 xd]].
by rewrite /turn cycle4_out ?turn_uniq // !inE !negb_or xh1 xb xt1.
Qed.

Lemma turn_self : turn s h h = h.
Proof.
rewrite /turn cycle4_out ?turn_uniq //; have := quad_uniq; rewrite /= !inE !negb_or.
by case/andP=> /and5P[-> -> _ -> ->].
Qed.

Lemma turn_twin : turn s h t = t.
Proof.
rewrite /turn cycle4_out ?turn_uniq //; have := quad_uniq; rewrite /= !inE !negb_or.
case/and5P=> /and5P[_ _ ht _ _] /and4P[_ h1t _ _] /and3P[bt _ _] /andP[tt1 td] _.
by rewrite [t == _]eq_sym h1t [t == prev s h]eq_sym bt tt1.
Qed.

(* What the flip does to next, dart by dart. *)
Lemma flip_turn x : next (flip h s) (turn s h x) = turn s h (next s x).
Proof. exact: permJ. Qed.

Lemma flip_twin x : twin (flip h s) x = twin s x.
Proof. by []. Qed.

Lemma flip_next_self : next (flip h s) h = prev s h.
Proof. by have := flip_turn h; rewrite turn_self turn_next. Qed.

Lemma flip_next_prev : next (flip h s) (prev s h) = next s t.
Proof. by have := flip_turn (next s h); rewrite turn_next turn_prev. Qed.

Lemma flip_next_next_twin : next (flip h s) (next s t) = h.
Proof. by have := flip_turn (prev s h); rewrite turn_prev prevK // turn_self. Qed.

Lemma flip_next_twin : next (flip h s) t = prev s t.
Proof. by have := flip_turn t; rewrite turn_twin turn_next_twin. Qed.

Lemma flip_next_prev_twin : next (flip h s) (prev s t) = next s h.
Proof. by have := flip_turn (next s t); rewrite turn_next_twin turn_prev_twin. Qed.

Lemma flip_next_next : next (flip h s) (next s h) = t.
Proof. by have := flip_turn (prev s t); rewrite turn_prev_twin prevK // turn_twin. Qed.

Lemma flip_next_out x : x \notin quad s h -> next (flip h s) x = next s x.
Proof.
move=> xq; have := flip_turn x; rewrite !turn_out //.
by rewrite quadE !same_face_next -quadE.
Qed.

(* The same as one expression. *)
Lemma flip_nextE x : next (flip h s) x =
  if x == h then prev s h else if x == prev s h then next s t else
  if x == next s t then h else if x == t then prev s t else
  if x == prev s t then next s h else if x == next s h then t else next s x.
Proof.
case: eqP => [->|/eqP x1]; first exact: flip_next_self.
case: eqP => [->|/eqP x2]; first exact: flip_next_prev.
case: eqP => [->|/eqP x3]; first exact: flip_next_next_twin.
case: eqP => [->|/eqP x4]; first exact: flip_next_twin.
case: eqP => [->|/eqP x5]; first exact: flip_next_prev_twin.
case: eqP => [->|/eqP x6]; first exact: flip_next_next.
by apply: flip_next_out; rewrite !inE !negb_or x1 x6 x2 x4 x3 x5.
Qed.

(* What it does to the labels. *)
Lemma flip_origin_self : origin (flip h s) h = corner s t.
Proof. by rewrite ffunE eqxx. Qed.

Lemma flip_origin_twin : origin (flip h s) t = corner s h.
Proof. by rewrite ffunE eqxx (negbTE (twin_neq wf h)). Qed.

Lemma flip_origin_out x : x != h -> x != t -> origin (flip h s) x = origin s x.
Proof. by move=> /negbTE xh /negbTE xt; rewrite ffunE xh xt. Qed.

Lemma flip_originE x : origin (flip h s) x =
  if x == h then corner s t else if x == t then corner s h else origin s x.
Proof. by rewrite ffunE. Qed.

(* Both sides of the edge give the same flip. *)
Lemma turn_other_side : turn s t = turn s h.
Proof.
rewrite /turn /t (twinK wf) -/t cycle4_rot; last by have := turn_uniq; rewrite -(rot_uniq 1).
by rewrite cycle4_rot // turn_uniq.
Qed.

Lemma flip_other_side : flip t s = flip h s.
Proof.
apply: surface_eq => [//||] x; first by rewrite /= turn_other_side.
rewrite !ffunE /t (twinK wf) -/t; case: (x =P t) => [->|] //.
by rewrite (negbTE (twin_neq wf h)).
Qed.

End Action.

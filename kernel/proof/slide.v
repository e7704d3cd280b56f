(* The slide: at a hub, two flips move one edge of the tree opposite to it along the next one.

   Let every face contain v.  Going round v one meets the edges opposite to it in order
   ([link_next]).  Let u -> x and x -> y be two of them, one after the other, with y different
   from u.  Flip the edge between them, which joins x to v: that joins u to y.  Then flip the edge
   x -> y, now between the faces x y u and x y v: that joins u to v.  Every face contains v again,
   and of the edges opposite to v one, from x to y, has been replaced by one from u to y
   ([slide]).  So u gains two darts and x loses two ([slide_degree]).  Going round v, one meets
   u -> y in place of u -> x -> y, and y -> u -> x in place of y -> x ([slide_link_g] and the three
   lemmas after it).  All of this holds for every genus. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach hub.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Link.

Variables D V : finType.
Variable s : surface D V.
Hypothesis gs : good s.
Implicit Types (x y e : D) (u v w : V).

Let wf : well_formed s := good_wf gs.

(* The edges opposite to v, in the order in which they go round v: the next one after e. *)
Definition link_next e := next s (twin s (next s e)).

Lemma origin_link_next e : origin s (link_next e) = origin s (next s e).
Proof. exact: origin_next_twin. Qed.

Lemma corner_link_next e : corner s (link_next e) = corner s e.
Proof. by rewrite /link_next corner_next // origin_twin. Qed.

(* A face has one side opposite to a corner. *)
Lemma corner_side x y : same_face s x y -> corner s x = corner s y -> x = y.
Proof.
have [_ n2 n3] := corner_neq x gs.
rewrite same_faceE // => /or3P[] /eqP-> //.
- by rewrite corner_next // => cx; rewrite cx eqxx in n3.
- by rewrite corner_prev // => cx; rewrite cx eqxx in n2.
Qed.

Variable v : V.
Hypothesis hub_v : hub s v.

(* At a hub the darts opposite to it are those of the edges which do not end there. *)
Lemma hub_corner x : (corner s x == v) = (origin s x != v) && (origin s (twin s x) != v).
Proof.
have [n1 n2 n3] := corner_neq x gs; rewrite origin_twin //.
apply/eqP/andP => [<-|[]]; first by rewrite eq_sym n3 n2.
by case/or3P: (hub_v x) => [->|->|/eqP].
Qed.

Lemma hub_twin x : (corner s (twin s x) == v) = (corner s x == v).
Proof. by rewrite !hub_corner (twinK wf) andbC. Qed.

Lemma hub_link_edge u : u != v -> exists2 e, corner s e = v & origin s e = u.
Proof.
move=> uv; have [x org_x] := label_used wf u.
case/or3P: (hub_v x) => [|/eqP org_nx|/eqP cx]; last by exists x.
  by rewrite org_x (negbTE uv).
exists (next s (twin s x)); last by rewrite origin_next_twin.
by rewrite corner_next // origin_twin.
Qed.

End Link.

Section Slide.

Variables D V : finType.
Variables (s : surface D V) (v : V) (e : D).

(* The edges u -> x and x -> y round v, and the dart g from x to v between them. *)
Let f := link_next s e.
Let g := next s e.
Let u := origin s e.
Let x := origin s f.
Let y := origin s (next s f).

Hypothesis gs : good s.
Hypothesis hub_v : hub s v.
Hypothesis ev : corner s e = v.
Hypothesis yu : y != u.

Let wf : well_formed s := good_wf gs.

Let fv : corner s f = v. Proof. by rewrite corner_link_next. Qed.
Let tfv : corner s (twin s f) = v. Proof. by apply/eqP; rewrite hub_twin // fv. Qed.
Let prev_g : prev s g = e. Proof. exact: nextK. Qed.
Let next_tg : next s (twin s g) = f. Proof. by []. Qed.

Let corner_g : corner s g = u. Proof. by rewrite corner_next. Qed.
Let corner_tg : corner s (twin s g) = y. Proof. by rewrite /corner /prev next_tg. Qed.

(* The first flip. *)
Lemma slide_allowed1 : allowed s g.
Proof. by rewrite /allowed corner_g corner_tg eq_sym. Qed.

Let s1 := flip g s.
Let gap : apart s g. Proof. by apply: allowed_apart => //; apply: slide_allowed1. Qed.

Let uv : u != v. Proof. by have [_ _] := corner_neq e gs; rewrite ev eq_sym. Qed.

(* The face behind x -> y takes no part in it. *)
Let tf_out : twin s f \notin quad s g.
Proof.
rewrite quadE //; apply/norP; split; apply/negP => same.
  have tfe : e = twin s f.
    apply: (corner_side gs); last by rewrite ev tfv.
    by apply: same_face_trans same; rewrite /g same_face_next same_face_refl.
  by move: yu; rewrite /y -origin_twin // -tfe eqxx.
have ftf : f = twin s f.
  apply: (corner_side gs); last by rewrite fv tfv.
  by apply: same_face_trans same; rewrite same_face_sym same_face_next same_face_refl.
by have := twin_neq wf f; rewrite -ftf eqxx.
Qed.

(* Between the flips the face at f has its other side at the hub, and u opposite. *)
Let next1_f : next s1 f = g. Proof. by rewrite /s1 -next_tg flip_next_next_twin. Qed.
Let next1_g : next s1 g = e. Proof. by rewrite /s1 flip_next_self // prev_g. Qed.

Let e_neq_g : e != g. Proof. exact: next_neq'. Qed.
Let e_neq_tg : e != twin s g.
Proof. by apply: contra uv => /eqP etg; rewrite /u etg origin_twin // -/(prev s e) -ev. Qed.

Let corner1_f : corner s1 f = u.
Proof. by rewrite /corner /prev next1_f next1_g /s1 flip_origin_out. Qed.

Let corner1_tf : corner s1 (twin s f) = v.
Proof.
have prev_out : prev s (twin s f) \notin quad s g.
  by move: tf_out; rewrite !quadE // /prev !same_face_next.
have next_out : next s (twin s f) \notin quad s g.
  by move: tf_out; rewrite !quadE // !same_face_next.
rewrite /corner /prev /s1 !flip_next_out // -/(prev s _) flip_origin_out ?[LHS]tfv //.
  by apply: contra prev_out => /eqP->; rewrite inE eqxx.
by apply: contra prev_out => /eqP->; rewrite !inE eqxx !orbT.
Qed.

(* The second flip. *)
Lemma slide_allowed2 : allowed s1 f.
Proof. by rewrite /allowed corner1_f corner1_tf. Qed.

Let s2 := flip f s1.

(* Which darts start where after a slide: nothing but the two edges has changed. *)
Lemma slide_origin z : origin s2 z =
  if z == f then v else if z == twin s f then u else
  if z == g then y else if z == twin s g then u else origin s z.
Proof. by rewrite !flip_originE corner1_f corner1_tf corner_g corner_tg. Qed.

Let gs1 : good s1. Proof. by apply: flip_good => //; apply: slide_allowed1. Qed.
Let wf1 : well_formed s1 := good_wf gs1.

Lemma slide_good : good s2.
Proof. exact: flip_good gs1 slide_allowed2. Qed.

(* One edge opposite to v has moved its end from x to u: u gains two darts, x loses two. *)
Lemma slide_degree w : degree s2 w + (x == w) * 2 = degree s w + (u == w) * 2.
Proof.
have := degree_flip f w wf1; have := degree_flip g w wf.
rewrite corner_g corner_tg corner1_f corner1_tf -/s1 -/s2.
have -> : origin s g = x by rewrite /x origin_link_next.
have -> : origin s (twin s g) = v by rewrite origin_twin.
have -> : origin s1 f = x.
  rewrite /s1 flip_origin_out //.
    by apply: contra uv => /eqP fg; rewrite -corner_g -fg fv.
  have [_ yv _] := corner_neq f gs; rewrite fv -/y in yv.
  by apply: contra yv => /eqP fg; rewrite -corner_tg -fg fv.
have -> : origin s1 (twin s1 f) = y.
  rewrite /s1 flip_origin_out ?origin_twin //.
    by apply: contra tf_out => /eqP->; rewrite inE eqxx.
  by apply: contra tf_out => /eqP->; rewrite !inE eqxx !orbT.
move=> deg1 deg2; apply: (@addnI ((y == w) + (v == w))).
transitivity (degree s2 w + (x == w) + (y == w) + ((x == w) + (v == w))); first by ring.
rewrite deg2; transitivity (degree s1 w + (x == w) + (v == w) + ((u == w) + (v == w))).
  by ring.
by rewrite deg1; ring.
Qed.

Lemma slide_hub : hub s2 v.
Proof.
apply/(hubP v slide_good); rewrite faces_flip ?slide_allowed2 // faces_flip ?slide_allowed1 //.
rewrite -((hubP v gs).1 hub_v).
have xv : x != v by rewrite /x origin_link_next // -ev; case: (corner_neq e gs).
by have := slide_degree v; rewrite (negbTE xv) (negbTE uv) !addn0.
Qed.

(* Which dart follows which after a slide, first within the three faces, then outside of them. *)
Let ap1 : apart s1 f. Proof. by apply: allowed_apart => //; apply: slide_allowed2. Qed.

Let next1_out z : z \notin quad s g -> next s1 z = next s z.
Proof. exact: flip_next_out. Qed.

Let next1_tf : next s1 (twin s f) = next s (twin s f).
Proof. exact: next1_out. Qed.

Let prev1_tf : prev s1 (twin s f) = prev s (twin s f).
Proof.
rewrite /prev next1_tf next1_out //.
by move: tf_out; rewrite !quadE // !same_face_next.
Qed.

Let prev1_f : prev s1 f = e. Proof. by rewrite /prev next1_f. Qed.

Lemma slide_next_g : next s2 g = twin s f.
Proof. by rewrite -{1}next1_f flip_next_next. Qed.

Lemma slide_next_f : next s2 f = e.
Proof. by rewrite flip_next_self. Qed.

Lemma slide_next_e : next s2 e = next s (twin s f).
Proof. by rewrite -{1}prev1_f flip_next_prev. Qed.

Lemma slide_next_prev_tf : next s2 (prev s (twin s f)) = g.
Proof. by rewrite -prev1_tf flip_next_prev_twin. Qed.

Let quad1 : quad s1 f = [:: f; g; e; twin s f; next s (twin s f); prev s (twin s f)].
Proof. by rewrite /quad prev1_f prev1_tf next1_f next1_tf. Qed.

Let f_neq_e : f != e.
Proof.
apply/eqP => fe; have [n1 _ _] := corner_neq e gs.
by move: n1; rewrite -origin_link_next // -/f fe eqxx.
Qed.

Let tf_neq_e : twin s f != e.
Proof. by apply: contra yu => /eqP tfe; rewrite /y -origin_twin // tfe. Qed.

Let other_face a b : corner s a = v -> corner s b = v -> a != b -> ~~ same_face s a b.
Proof. by move=> av bv; apply: contra => /corner_side; rewrite av bv => ->. Qed.

Let same_prev a b : same_face s a (prev s b) = same_face s a b.
Proof. by rewrite /prev !same_face_next. Qed.

Let out1 z : ~~ same_face s e z -> ~~ same_face s (twin s f) z -> z != f -> z \notin quad s1 f.
Proof.
move=> ez tfz zf; rewrite quad1 !inE (negbTE zf) /=.
apply/negP => /or4P[/eqP zg|/eqP ze|/eqP ztf|/orP[/eqP zn|/eqP zp]].
- by rewrite zg /g same_face_next same_face_refl in ez.
- by rewrite ze same_face_refl in ez.
- by rewrite ztf same_face_refl in tfz.
- by rewrite zn same_face_next same_face_refl in tfz.
- by rewrite zp same_prev same_face_refl in tfz.
Qed.

Lemma slide_next_out z : ~~ same_face s e z -> ~~ same_face s f z -> ~~ same_face s (twin s f) z ->
  next s2 z = next s z.
Proof.
move=> ez fz tfz; rewrite flip_next_out ?next1_out //.
  have same_g : same_face s g z = same_face s e z.
    by rewrite same_face_sym same_face_next same_face_sym.
  have same_tg : same_face s (twin s g) z = same_face s f z.
    by rewrite same_face_sym -same_face_next same_face_sym next_tg.
  by rewrite quadE // same_g same_tg negb_or ez fz.
apply: out1 => //; apply: contra fz => /eqP->; exact: same_face_refl.
Qed.

(* After a slide the edges opposite to v follow each other as before, but that twin g: u -> y stands
   for e and f, and g: y -> u and then e: u -> x for twin f. *)
Definition moved z := if z == e then twin s g else if z == twin s f then g else z.

Let next2_prev c : corner s c = v -> c != f -> next s2 (prev s c) = moved c.
Proof.
move=> cv cf; have [->|ce] := eqVneq c e.
  have far a b : corner s a = v -> e != a -> same_face s a b -> prev s e != b.
    move=> av ea; apply: contraTneq => <-; rewrite same_prev same_face_sym.
    exact: other_face.
  rewrite /moved eqxx flip_next_out //; first exact: flip_next_next.
  rewrite quad1 !inE !negb_or (prev_next_neq wf) (prev_neq wf) (far f) ?same_face_refl //=.
    by rewrite !(far (twin s f)) ?same_prev ?same_face_next ?same_face_refl // eq_sym.
  by rewrite eq_sym.
have [->|ctf] := eqVneq c (twin s f).
  by rewrite slide_next_prev_tf /moved (negbTE tf_neq_e) eqxx.
rewrite slide_next_out ?same_prev ?other_face ?prevK // 1?eq_sym //.
by rewrite /moved (negbTE ce) (negbTE ctf).
Qed.

Let twin_next z : twin s (next s z) = prev s (link_next s z).
Proof. by rewrite /link_next nextK. Qed.

Let link_neq_f z : z != e -> link_next s z != f.
Proof. by apply: contra => /eqP /next_inj /twin_inj /next_inj ->. Qed.

Let next2_tg : next s2 (twin s g) = next s f.
Proof.
have tg_f : twin s g = prev s f by rewrite -next_tg nextK.
have far b : same_face s (twin s f) b -> twin s g != b.
  apply: contraTneq => <-; rewrite tg_f same_prev; apply: other_face => //.
  exact: twin_neq.
rewrite flip_next_out //; first by rewrite flip_next_twin // /prev next_tg.
have tg_neq_f : twin s g != f by rewrite tg_f prev_neq.
rewrite quad1 !inE !negb_or tg_neq_f twin_neq // [_ == e]eq_sym e_neq_tg.
by rewrite !far ?same_prev ?same_face_next ?same_face_refl.
Qed.

Lemma slide_link_g : link_next s2 g = e.
Proof. by rewrite /link_next slide_next_g (twinK wf) slide_next_f. Qed.

Lemma slide_link_tg : link_next s2 (twin s g) = moved (link_next s f).
Proof.
rewrite {1}/link_next next2_tg [twin s2 _]twin_next next2_prev ?link_neq_f //.
by rewrite corner_link_next.
Qed.

Lemma slide_link_e : link_next s2 e = moved (link_next s (twin s f)).
Proof.
rewrite {1}/link_next slide_next_e [twin s2 _]twin_next next2_prev ?link_neq_f //.
by rewrite corner_link_next.
Qed.

Lemma slide_link_out z : corner s z = v -> z != e -> z != f -> z != twin s f ->
  link_next s2 z = moved (link_next s z).
Proof.
move=> zv ze zf ztf; have next_z : next s2 z = next s z.
  by rewrite slide_next_out // other_face // eq_sym.
by rewrite {1}/link_next next_z [twin s2 _]twin_next next2_prev ?link_neq_f // corner_link_next.
Qed.

End Slide.

(* The slide lemma: let e = u -> x and f = x -> y be opposite to v and consecutive, y different from
   u, and let g be the dart x -> v between them.  Flipping g and then f is allowed; every face
   contains v again; f and its twin now join v and u, g and its twin now join y and u, and every
   other dart starts where it did. *)
Theorem slide (D V : finType) (s : surface D V) (v : V) (e : D) :
  let f := link_next s e in let g := next s e in
  let u := origin s e in let y := origin s (next s f) in
  good s -> hub s v -> corner s e = v -> y != u ->
  let s' := flip f (flip g s) in
  [/\ allowed s g /\ allowed (flip g s) f, good s', hub s' v &
      forall z, origin s' z =
        if z == f then v else if z == twin s f then u else
        if z == g then y else if z == twin s g then u else origin s z].
Proof.
move=> f g u y gs hub_v ev yu s'; split.
- by split; [exact: slide_allowed1|exact: (slide_allowed2 gs hub_v)].
- exact: slide_good.
- exact: slide_hub.
- exact: slide_origin.
Qed.

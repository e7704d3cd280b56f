(* The group of one flip, and how local it is.

   [flip_twice]: two flips of an edge give the old surface with the two darts of the edge
   exchanged.  [flip_order_four]: four flips are the identity.  [unflip] (flip.v) is the exact
   inverse on both sides: [flipK] in invariants.v and [unflipK] here.  [theorem_4_2_local]: twin is
   never changed, next only in the two faces at the edge, origin only at the edge's own darts, and
   no edge outside the two faces changes its guard. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Order.

Variables D V : finType.
Implicit Types (s : surface D V) (h : D).

(* Twice: the two darts of the edge have changed places. *)
Theorem flip_twice s h : well_formed s -> apart s h ->
  flip h (flip h s) = rename (tperm h (twin s h)) s.
Proof.
move=> wf hap; set t := twin s h; set s1 := flip h s.
have E := quad_neqs wf hap; rewrite -/t in E.
have wf1 : well_formed s1 by apply: flip_well_formed.
have hap1 : apart s1 h by apply: flip_apart.
have b1 : next s1 h = prev s h by apply: flip_next_self.
have b2 : prev s1 h = next s t by apply: flip_prev_self.
have b3 : next s1 t = prev s t by apply: flip_next_twin.
have b4 : prev s1 t = next s h by apply: flip_prev_twin.
have f_h : next (flip h s1) h = next s t by rewrite flip_next_self.
have f_h1 : next (flip h s1) (next s h) = prev s h.
  by rewrite -b4 -b1; apply: flip_next_prev_twin.
have f_b : next (flip h s1) (prev s h) = t by rewrite -b1; apply: flip_next_next.
have f_t : next (flip h s1) t = next s h by rewrite -b4; apply: flip_next_twin.
have f_t1 : next (flip h s1) (next s t) = prev s t.
  by rewrite -b2 -b3; apply: flip_next_prev.
have f_d : next (flip h s1) (prev s t) = h by rewrite -b3; apply: flip_next_next_twin.
have fixed x : x != h -> x != t -> tperm h t x = x by move=> xh xt; rewrite tpermD // eq_sym.
apply: surface_eq => x.
- rewrite [RHS]/= -[x in RHS](tpermK h t) permJ /=.
  case: (x =P h) => [->|/eqP xh]; first by rewrite tpermL [twin s t](twinK wf) tpermL.
  case: (x =P t) => [->|/eqP xt]; first by rewrite tpermR -/t tpermR [LHS](twinK wf).
  rewrite !fixed // ?fixed //.
    by rewrite -(twinK wf h) (inj_eq (@twin_inj _ _ s)).
  by rewrite (inj_eq (@twin_inj _ _ s)).
- rewrite [RHS]/= -[x in RHS](tpermK h t) permJ /=.
  have [in_q|out] := boolP (x \in quad s h); last first.
    have : next s x \notin quad s h by rewrite quadE // !same_face_next -quadE.
    have : x \notin quad s1 h.
      move: out; rewrite !inE b1 b2 -[twin s1 h]/t b3 b4 !negb_or -/t.
      by case/and5P=> -> -> -> -> /andP[-> ->].
    move=> out1 out2; rewrite flip_next_out // [LHS]flip_next_out //.
    move: out out2; rewrite !inE !negb_or -/t => /and5P[xh _ _ xt _] /and5P[nh _ _ nt _].
    by rewrite (fixed x) // fixed.
  move: in_q; rewrite !inE -/t; case/or3P => [/eqP->|/eqP->|/or4P[] /eqP->].
  - by rewrite [LHS]f_h tpermL fixed ?E.
  - by rewrite [LHS]f_h1 [tperm h t (next s h)]fixed ?E // fixed ?E.
  - by rewrite [LHS]f_b [tperm h t (prev s h)]fixed ?E // prevK // tpermL.
  - by rewrite [LHS]f_t tpermR fixed ?E.
  - by rewrite [LHS]f_t1 [tperm h t (next s t)]fixed ?E // fixed ?E.
  - by rewrite [LHS]f_d [tperm h t (prev s t)]fixed ?E // prevK // tpermR.
- rewrite !ffunE tpermV -[twin s1 h]/t flip_corner_self // [corner s1 t]flip_corner_twin //.
  case: (x =P h) => [->|/eqP xh]; first by rewrite tpermL.
  case: (x =P t) => [->|/eqP xt]; first by rewrite tpermR.
  by rewrite fixed.
Qed.

(* Four times: nothing has changed. *)
Theorem flip_order_four s h : well_formed s -> apart s h ->
  flip h (flip h (flip h (flip h s))) = s.
Proof.
move=> wf hap; have wf1 := flip_well_formed wf hap; have hap1 := flip_apart wf hap.
have wf2 := flip_well_formed wf1 hap1; have hap2 := flip_apart wf1 hap1.
rewrite [flip h (flip h (flip h (flip h s)))]flip_twice //.
rewrite -[twin (flip h (flip h s)) h]/(twin s h) flip_twice //.
apply: surface_eq => x; rewrite /= ?ffunE; last by rewrite !tpermV tpermK.
  by rewrite -conjgM tperm2 conjg1.
by rewrite -conjgM tperm2 conjg1.
Qed.

(* The inverse is three more flips, and so it is an inverse on both sides. *)
Theorem unflip_flip3 s h : well_formed s -> apart s h -> unflip h s = flip h (flip h (flip h s)).
Proof.
move=> wf hap; have wf1 := flip_well_formed wf hap; have hap1 := flip_apart wf hap.
have wf2 := flip_well_formed wf1 hap1; have hap2 := flip_apart wf1 hap1.
have wf3 := flip_well_formed wf2 hap2; have hap3 := flip_apart wf2 hap2.
by rewrite -{1}(flip_order_four wf hap) flipK.
Qed.

(* It differs from the flip only in the names of the edge's two darts. *)
Lemma unflip_rename s h : well_formed s -> apart s h ->
  unflip h s = rename (tperm h (twin s h)) (flip h s).
Proof.
move=> wf hap; rewrite unflip_flip3 //.
exact: flip_twice (flip_well_formed wf hap) (flip_apart wf hap).
Qed.

Theorem unflipK s h : well_formed s -> apart s h -> flip h (unflip h s) = s.
Proof. by move=> wf hap; rewrite unflip_flip3 // flip_order_four. Qed.

(* Locality: an edge beside neither of the two faces keeps its faces, its corners and its guard. *)
Theorem theorem_4_2_local s h : well_formed s -> apart s h ->
  [/\ forall x, twin (flip h s) x = twin s x,
      forall x, x \notin quad s h -> next (flip h s) x = next s x,
      forall x, x != h -> x != twin s h -> origin (flip h s) x = origin s x
    & forall x, x \notin quad s h -> twin s x \notin quad s h ->
        allowed (flip h s) x = allowed s x].
Proof.
move=> wf hap; have next_out := @flip_next_out _ _ s wf h.
have origin_out := @flip_origin_out _ _ s h.
split=> // x out tw_out; have corner_out y : y \notin quad s h ->
    corner (flip h s) y = corner s y.
  move=> y_out; have ny_out : next s y \notin quad s h.
    by rewrite quadE // !same_face_next -quadE.
  have py_out : next s (next s y) \notin quad s h by rewrite quadE // !same_face_next -quadE.
  rewrite /corner /prev !next_out // origin_out //.
    by apply: contra py_out => /eqP->; rewrite !inE eqxx.
  by apply: contra py_out => /eqP->; rewrite !inE eqxx !orbT.
by rewrite /allowed !corner_out.
Qed.

End Order.

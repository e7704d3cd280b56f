(* The hub: every surface can be flipped until one vertex lies in every face.

   Let v be a vertex.  A face without loops contains v at most once, so the degree of v counts the
   faces that contain v.  While there is another face, some edge opposite to v in a face has
   another corner than v on its far side ([hub_step]); its flip joins v to that corner, so the
   degree of v rises by one.  So as many flips as there are faces without v lead to a surface
   with v in every face ([gather]), for every genus; and fewer cannot ([gather_least]).  On
   a sphere they are at most 2 V - 6, so at most 2 V - 4 ([gather_sphere]). *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants reach.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Degree.

Variables D V : finType.
Implicit Types (s : surface D V) (x y h : D) (u v w : V).

(* The degree of a vertex: the number of darts that start there. *)
Definition degree s v := #|[set x | origin s x == v]|.

Lemma degree_sum s v : degree s v = \sum_x (origin s x == v).
Proof. by rewrite /degree -sum1dep_card big_mkcond. Qed.

Lemma corner_next s x : well_formed s -> corner s (next s x) = origin s x.
Proof. by move=> wf; rewrite /corner nextK. Qed.

Lemma corner_prev s x : well_formed s -> corner s (prev s x) = origin s (next s x).
Proof. by move=> wf; rewrite /corner /prev (next3 wf). Qed.

(* The corners of a face are different. *)
Lemma corner_neq s x : good s ->
  [/\ origin s x != origin s (next s x), origin s (next s x) != corner s x &
      corner s x != origin s x].
Proof.
case=> wf loopl _; split; [exact: loopl|exact: loopl|].
by have := loopl (prev s x); rewrite (prevK wf).
Qed.

Lemma at_face_sum s v x : good s ->
  at_face s v x = (origin s x == v) + (origin s (next s x) == v) + (corner s x == v) :> nat.
Proof.
move=> gs; have [n1 n2 n3] := corner_neq x gs; rewrite /at_face.
case: (eqVneq (origin s x) v) => [<-|_] /=.
  by rewrite eq_sym (negbTE n1) (negbTE n3).
case: (eqVneq (origin s (next s x)) v) => [<-|_] //=.
by rewrite eq_sym (negbTE n2).
Qed.

Lemma at_face_next s v x : well_formed s -> at_face s v (next s x) = at_face s v x.
Proof.
move=> wf; rewrite /at_face corner_next //.
by rewrite -/(corner s x) orbA orbC.
Qed.

(* Each face that contains v contains it once, so the degree counts these faces. *)
Lemma degree3 s v : good s -> degree s v * 3 = #|[set x | at_face s v x]|.
Proof.
move=> gs; have wf := good_wf gs; rewrite -sum1dep_card big_mkcond /=.
rewrite (eq_bigr _ (fun x _ => at_face_sum v x gs)) !big_split /=.
have sum_next : \sum_x (origin s (next s x) == v) = degree s v.
  by rewrite degree_sum [RHS](reindex_inj (@next_inj _ _ s)).
have sum_corner : \sum_x (corner s x == v) = degree s v.
  by rewrite degree_sum [RHS](reindex_inj (@prev_inj _ _ s)) /corner.
by rewrite sum_next sum_corner -degree_sum mulnC !mulSn mul0n addn0 addnA.
Qed.

Lemma degree_le s v : good s -> degree s v <= faces s.
Proof.
move=> gs; rewrite -(leq_pmul2r (isT : 0 < 3)) degree3 // faces3; last exact: good_wf.
exact: max_card.
Qed.

Lemma hubP s v : good s -> hub s v <-> degree s v = faces s.
Proof.
move=> gs; have wf := good_wf gs; split=> [hub_v|deg_v].
  apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) degree3 // faces3 //.
  by apply/eqP/eq_card => x; rewrite !inE; apply: hub_v.
have: [set x | at_face s v x] == [set: D].
  by rewrite eqEcard subsetT -degree3 // deg_v faces3 // cardsT /=.
by move/eqP/setP => all_x x; have := all_x x; rewrite !inE.
Qed.

(* A vertex of a surface without loops has at least two darts. *)
Lemma degree_ge2 s v : good s -> 1 < degree s v.
Proof.
move=> gs; have [wf loopl _] := gs; have [x org_x] := label_used wf v.
have org_y : origin s (next s (twin s x)) == v by rewrite origin_next_twin // org_x.
rewrite /degree (cardsD1 x) (cardsD1 (next s (twin s x))) !inE org_x eqxx org_y andbT.
case: eqP => [tx|_] //=; exfalso.
have tx' : twin s x = prev s x by rewrite -{2}tx nextK.
have := loopl (next s x); rewrite -/(prev s x) -tx' origin_twin //.
by rewrite eqxx.
Qed.

(* If v is not in every face, some edge opposite to it has another far corner. *)
Lemma hub_edge s v : good s -> ~ hub s v ->
  exists h, corner s h = v /\ corner s (twin s h) != v.
Proof.
move=> gs not_hub; have [wf _ conn] := gs.
case: (pickP [pred h | (corner s h == v) && (corner s (twin s h) != v)]) => [h|none].
  by case/andP => /eqP; exists h.
have [x0 org_x0] := label_used wf v.
case: not_hub => x; case/connectP: (conn x0 x) => p path_p ->.
have at_x0 : at_face s v x0 by rewrite /at_face org_x0 eqxx.
elim: p x0 at_x0 path_p {x org_x0} => //= y p IHp x at_x /andP[link_xy]; apply: IHp.
case/orP: link_xy => /eqP->; last by rewrite at_face_next.
case/or3P: at_x => [org_x|org_nx|corner_x]; rewrite /at_face.
- by rewrite origin_next_twin // org_x orbT.
- by rewrite origin_twin // org_nx.
- by have := none x; rewrite /= corner_x => /negbFE->; rewrite !orbT.
Qed.


(* What a flip does to the degrees: the ends of the edge lose one, the opposite corners gain one. *)
Lemma degree_flip s h w : well_formed s ->
  degree (flip h s) w + (origin s h == w) + (origin s (twin s h) == w) =
  degree s w + (corner s h == w) + (corner s (twin s h) == w).
Proof.
move=> wf; rewrite !degree_sum (bigD1 h) //= [X in _ = X + _ + _](bigD1 h) //=.
have th : twin s h != h := twin_neq wf h.
rewrite (bigD1 (twin s h)) //= [X in _ = _ + X + _ + _](bigD1 (twin s h)) //=.
rewrite flip_origin_self flip_origin_twin //.
set others := \sum_(i | _) _; set others' := \sum_(i | _) _.
have -> : others = others'.
  by apply: eq_bigr => x /andP[xh xt]; rewrite flip_origin_out.
by ring.
Qed.

Lemma degree_flip_le s h w : well_formed s -> allowed s h ->
  degree (flip h s) w <= (degree s w).+1.
Proof.
move=> wf ok; apply: (@leq_trans (degree s w + (corner s h == w) + (corner s (twin s h) == w))).
  by rewrite -degree_flip // -addnA leq_addr.
rewrite -addnA -addn1 leq_add2l; move: ok; rewrite /allowed.
case: (eqVneq (corner s h) w) => [->|_ _]; last exact: leq_b1.
by rewrite eq_sym => /negbTE->.
Qed.

Lemma faces_flip s h : good s -> allowed s h -> faces (flip h s) = faces s.
Proof.
by move=> [wf _ _] ok; apply: flip_faces => //; apply: allowed_apart.
Qed.

Lemma reach_in_faces s n s' : reach_in s n s' -> good s -> faces s' = faces s.
Proof.
by elim=> // {}s h {}n {}s' ok _ IH gs; rewrite IH ?faces_flip //; apply: flip_good.
Qed.

(* In every surface without loops: while some face does not contain v, there is an edge whose flip
   is allowed and raises the degree of v by one. *)
Theorem hub_step s v : good s -> ~ hub s v ->
  exists h, [/\ corner s h = v, allowed s h & degree (flip h s) v = (degree s v).+1].
Proof.
move=> gs not_hub; have [h [ch cth]] := hub_edge gs not_hub.
have [wf _ _] := gs; have [_ n2 n3] := corner_neq h gs.
exists h; split=> //; first by rewrite /allowed ch eq_sym.
have := degree_flip h v wf; rewrite ch eqxx (negbTE cth) origin_twin //.
by rewrite -ch [_ == corner s h]eq_sym (negbTE n3) (negbTE n2) !addn0 addn1.
Qed.

(* So as many flips as faces do not contain v lead to a surface whose every face does. *)
Theorem gather s v : good s ->
  exists s', [/\ reach_in s (faces s - degree s v) s', good s' & hub s' v].
Proof.
move def_n: (faces s - degree s v) => n; elim: n s def_n => [|n IHn] s def_n gs.
  exists s; split=> //; first exact: reach_in0.
  by apply/(hubP v gs)/eqP; rewrite eqn_leq degree_le // -subn_eq0 def_n.
have not_hub : ~ hub s v by move/(hubP v gs) => deg_v; rewrite deg_v subnn in def_n.
have [h [_ ok deg']] := hub_step gs not_hub; have gs' := flip_good gs ok.
have [|s' [r gs2 hub2]] := IHn (flip h s) _ gs'.
  by rewrite faces_flip // deg' subnS def_n.
by exists s'; split=> //; apply: reach_inS r.
Qed.

(* Fewer flips cannot do it, for no flip raises a degree by more than one. *)
Theorem gather_least s v n s' : good s -> reach_in s n s' -> hub s' v ->
  faces s - degree s v <= n.
Proof.
move=> gs r; elim: r gs => [{}s|{}s h {}n {}s' ok r IH] gs hub'.
  by rewrite ((hubP v gs).1 hub') subnn.
have := IH (flip_good gs ok) hub'; rewrite faces_flip // !leq_subLR => /leq_trans; apply.
by rewrite addnS -addSn leq_add2r degree_flip_le //; apply: good_wf.
Qed.

(* On a sphere. *)
Corollary gather_sphere s v : good s -> sphere s -> 2 * #|V| >= (faces s - degree s v) + 6.
Proof.
move=> gs sph; rewrite -(sphere_faces (good_wf gs) sph) -[6]/(2 + 4) addnA leq_add2r.
by rewrite -{2}(subnK (degree_le v gs)) leq_add2l degree_ge2.
Qed.

End Degree.

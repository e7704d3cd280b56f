(* The star: at a hub v, slides bring every face to any second vertex u.

   Let every face contain v.  While some face does not contain u, there are two consecutive edges
   u -> x and x -> y round v with y different from u.  For otherwise every edge opposite to v would
   have an end at u, since they follow each other in one cycle round v and one of them starts at u
   ([stuck_hub]).  A slide gives u two more darts.  So two flips for each two missing faces lead to
   a surface in which every face contains both v and u: a book ([star_at_hub], and [star] together
   with the flips that gather all faces at v).  Nothing so far asks for a sphere.

   On a sphere the pages of a book are leaves ([book_pages]): each vertex but v and u has exactly
   two darts, one to v and one to u, by counting.  At most 4 V - 12 flips lead there
   ([star_sphere]). *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach hub slide.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Star.

Variables D V : finType.
Implicit Types (s : surface D V) (x y e h : D) (u v w : V).

(* Where no edge round v can slide to u, every face contains u as well. *)
Lemma stuck_hub s v u : good s -> hub s v -> u != v ->
  (forall e, corner s e = v -> origin s e = u -> origin s (next s (link_next s e)) = u) ->
  hub s u.
Proof.
move=> gs hub_v uv stuck; have [wf _ _] := gs.
pose at_u e := (origin s e == u) || (origin s (next s e) == u).
have at_u_next e : corner s e = v -> at_u e -> at_u (link_next s e).
  move=> ce /orP[/eqP org_e|org_ne]; rewrite /at_u; first by rewrite stuck // eqxx orbT.
  by rewrite (origin_link_next gs) org_ne.
have link_at_u e : corner s e = v -> at_u e.
  move=> ce; have [e0 ce0 org_e0] := hub_link_edge gs hub_v uv.
  have at_e0 : at_u e0 by rewrite /at_u org_e0 eqxx.
  have: prev s e0 \in porbit (sigma s) (prev s e).
    by rewrite -label_orbit // -!/(corner s _) ce ce0.
  case/porbitP => n; elim: n e ce => [|n IHn] e ce.
    by rewrite perm1 => /prev_inj <-.
  rewrite expgS permM sigmaE => def_e0.
  pose e' := next s (next s (twin s (prev s e))).
  have e'E : link_next s e' = e.
    by rewrite /link_next /e' (next3 wf) (twinK wf) prevK.
  have ce' : corner s e' = v by rewrite -(corner_link_next gs) e'E.
  rewrite -e'E; apply: at_u_next => //; apply: IHn => //.
  by rewrite def_e0 /e' /prev (next3 wf).
move=> x; rewrite /at_face; case/or3P: (hub_v x) => [/eqP org_x|/eqP org_nx|/eqP cx].
- have := link_at_u (next s x); rewrite corner_next // => /(_ org_x).
  by rewrite /at_u /corner => ->; rewrite orbT.
- have := link_at_u (prev s x); rewrite corner_prev // => /(_ org_nx).
  by rewrite /at_u prevK // => /orP[] ->; rewrite ?orbT.
- by have /orP[] := link_at_u x cx => ->; rewrite ?orbT.
Qed.

(* Otherwise there are two consecutive edges u -> x -> y round v with y different from u. *)
Lemma slide_edge s v u : good s -> hub s v -> u != v -> ~ hub s u ->
  exists e, [/\ corner s e = v, origin s e = u & origin s (next s (link_next s e)) != u].
Proof.
move=> gs hub_v uv not_hub.
case: (pickP [pred e | [&& corner s e == v, origin s e == u &
    origin s (next s (link_next s e)) != u]]) => [e|none].
  by case/and3P => /eqP ? /eqP ? ?; exists e.
case: not_hub; apply: (stuck_hub gs hub_v uv) => e ce org_e; apply/eqP.
by have /= := none e; rewrite ce org_e !eqxx => /negbFE.
Qed.

(* Every dart starts somewhere. *)
Lemma degrees s : \sum_w degree s w = #|D|.
Proof.
rewrite (eq_bigr _ (fun w _ => degree_sum s w)) exchange_big /= -sum1_card.
apply: eq_bigr => x _; rewrite (bigD1 (origin s x)) //= eqxx big1 // => w.
by rewrite eq_sym => /negbTE->.
Qed.

Theorem book_pages s v u : good s -> sphere s -> v != u -> book s v u ->
  forall w, w != v -> w != u -> degree s w = 2.
Proof.
move=> gs sph vu [hub_v hub_u] w wv wu; have [wf _ _] := gs.
have deg_v := (hubP v gs).1 hub_v; have deg_u := (hubP u gs).1 hub_u.
pose page := [pred z | (z != v) && (z != u)].
have pages : #|page| + 2 = #|V|.
  have := cardC (pred2 v u); rewrite card2 vu addnC => <-; congr (_ + _).
  by apply: eq_card => z; rewrite !inE negb_or.
have sum_pages : \sum_(z | page z) degree s z = faces s.
  have := degrees s; rewrite (bigD1 v) //= (bigD1 u) /=; last by rewrite eq_sym.
  rewrite deg_v deg_u -(faces3 wf) mulnC !mulSn mul0n addn0.
  by move/eqP; rewrite !eqn_add2l => /eqP.
have two_pages : faces s = #|page| * 2.
  have := sphere_faces wf sph; rewrite -pages mulnC mulnDl.
  by move/eqP; rewrite eqn_add2r => /eqP.
have [_] := leqif_sum (fun z (_ : page z) => leqif_geq (degree_ge2 z gs)).
rewrite sum_nat_const sum_pages two_pages eqxx => /esym /forall_inP /(_ w).
rewrite inE wv wu => /(_ isT) le2; apply/eqP.
by rewrite eqn_leq le2; apply: degree_ge2.
Qed.

(* At a hub v: as many flips as faces do not contain u, two for each slide. *)
Theorem star_at_hub s v u : good s -> hub s v -> u != v ->
  exists s', [/\ reach_in s (faces s - degree s u) s', good s' & book s' v u].
Proof.
have [n] := ubnP (faces s - degree s u); elim: n s => // n IHn s le_n gs hub_v uv.
case: (boolP [forall x, at_face s u x]) => [/forallP hub_u|/forallP not_hub].
  rewrite ((hubP u gs).1 hub_u) subnn; exists s; split=> //; exact: reach_in0.
have [e [ev eu yu]] := slide_edge gs hub_v uv not_hub; rewrite -eu in yu.
have [[ok1 ok2] gs' hub' _] := slide gs hub_v ev yu.
have := slide_degree gs hub_v ev yu u.
set s' := flip (link_next s e) (flip (next s e) s) in gs' hub' *.
have /negbTE-> : origin s (link_next s e) != u.
  by rewrite origin_link_next // -eu eq_sym; case: (corner_neq e gs).
rewrite eu eqxx addn0 mul1n => deg'.
have faces' : faces s' = faces s.
  by rewrite -(reach_in_faces (reach_inS ok1 (reach_in1 ok2)) gs).
have le_deg := degree_le u gs'; rewrite faces' deg' in le_deg.
have missing : faces s - degree s u = (faces s' - degree s' u).+2.
  by rewrite faces' deg' subnDA -addn2 subnK // ltn_subRL -addnS.
have [|//|//|//|s2 [r gs2 book2]] := IHn s'.
  by rewrite missing ltnS in le_n; apply: leq_trans le_n.
exists s2; split=> //; rewrite missing.
exact: reach_inS ok1 (reach_inS ok2 r).
Qed.

(* From every surface without loops, for any two vertices v and u, to one whose every face contains
   both, with less than two flips a face. *)
Theorem star s v u : good s -> u != v ->
  exists n s', [/\ reach_in s n s', good s', book s' v u & n + degree s v + 2 <= 2 * faces s].
Proof.
move=> gs uv; have [s1 [r1 gs1 hub1]] := gather v gs.
have [s2 [r2 gs2 book2]] := star_at_hub gs1 hub1 uv.
exists (faces s - degree s v + (faces s1 - degree s1 u)), s2; split=> //.
  exact: reach_in_trans r1 r2.
rewrite [_ + degree s v]addnAC subnK ?degree_le // -(reach_in_faces r1 gs).
rewrite mul2n -addnn -addnA leq_add2l.
by rewrite -{2}(subnK (degree_le u gs1)) leq_add2l degree_ge2.
Qed.

(* On a sphere: at most 4 V - 12 flips lead to a book, whose pages are leaves. *)
Theorem star_sphere s v u : good s -> sphere s -> u != v ->
  exists n s', [/\ reach_in s n s', good s', book s' v u,
    (forall w, w != v -> w != u -> degree s' w = 2) & n + 12 <= 4 * #|V|].
Proof.
move=> gs sph uv; have [n [s' [r gs' book' bound]]] := star gs uv.
exists n, s'; split=> //.
  by apply: book_pages => //; [exact: reach_in_sphere r gs sph|rewrite eq_sym].
rewrite -[4]/(2 * 2) -mulnA -(sphere_faces (good_wf gs) sph) mulnDr -[12]/(2 + 2 + 8) !addnA.
rewrite leq_add2r; apply: leq_trans bound.
by rewrite leq_add2r leq_add2l degree_ge2.
Qed.

End Star.

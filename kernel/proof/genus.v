(* Every connected surface has a genus: V + F <= E + 2, and the difference is even.

   Parity is the sign of sigma = twin * next.  For the inequality the edges are put in one after
   the other, each as a transposition, from next to sigma.  First F - 1 edges that join two orbits
   each, which there are as long as there is more than one orbit, since the surface is connected;
   then each of the others, which makes at most one orbit more. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Join.

Variable D : finType.
Implicit Types (p : {perm D}) (x y z : D).

Lemma porbits_tperm_le p x y : #|porbits (tperm x y * p)%g| <= #|porbits p|.+1.
Proof.
have := porbits_mul_tperm p x y; rewrite /= => count.
apply: leq_trans (leq_addr (x \notin porbit p y).*2 _) _.
by rewrite count -addn1 leq_add2l leq_b1.
Qed.

Lemma porbits_join p x y : y \notin porbit p x -> #|porbits (tperm x y * p)%g|.+1 = #|porbits p|.
Proof.
move=> apart_xy; have := porbits_mul_tperm p x y; rewrite /= porbit_sym apart_xy.
have -> : x != y by apply: contra apart_xy => /eqP->; apply: porbit_id.
by rewrite addn2 addn1 => -[].
Qed.

(* The two orbits become one, *)
Lemma join_one p x y : y \notin porbit p x -> y \in porbit (tperm x y * p)%g x.
Proof.
move=> apart_xy; set q := (tperm x y * p)%g.
have back : (tperm x y * q)%g = p by rewrite mulgA tperm2 mul1g.
have := porbits_mul_tperm q x y; rewrite /= back porbit_sym -(porbits_join apart_xy).
case: (y \in _) => //; rewrite addn2 => /eqP; rewrite -addn2 -[_.+1]addn1 -addnA eqn_add2l.
by case: (x != y).
Qed.

(* and what was in one orbit stays in one. *)
Lemma join_step p x y z : y \notin porbit p x -> p z \in porbit (tperm x y * p)%g z.
Proof.
move=> apart_xy; have one := join_one apart_xy; set q := (tperm x y * p)%g in one *.
have q_x : q x = p y by rewrite permM tpermL.
have q_y : q y = p x by rewrite permM tpermR.
have [->|zx] := eqVneq z x.
  by rewrite -q_y -eq_porbit_mem; move: one; rewrite -!eq_porbit_mem => /eqP<-;
     rewrite eq_porbit_mem porbit_step.
have [->|zy] := eqVneq z y.
  by rewrite -q_x -eq_porbit_mem; move: one; rewrite -!eq_porbit_mem => /eqP->;
     rewrite eq_porbit_mem porbit_step.
have <- : q z = p z by rewrite permM tpermD // eq_sym.
exact: porbit_step.
Qed.

Lemma join_sub p x y z w : y \notin porbit p x -> w \in porbit p z ->
  w \in porbit (tperm x y * p)%g z.
Proof.
move=> apart_xy /porbitP[k ->]; elim: k => [|k IHk]; first by rewrite expg0 perm1 porbit_id.
have := join_step ((p ^+ k)%g z) apart_xy; rewrite -permM -expgSr.
by move: IHk; rewrite -!eq_porbit_mem => /eqP-> /eqP->.
Qed.

End Join.

Section Genus.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Hypothesis con : connected s.
Variable x0 : D.
Implicit Types (es : seq D) (x y : D).

(* Edges put in so far: one dart of each. *)
Definition edge_list es := uniq (es ++ map (twin s) es).

Definition put_in es : {perm D} := foldr (fun x p => (tperm x (twin s x) * p)%g) (next s) es.

Lemma edge_list_cons x es : edge_list es -> x \notin es ++ map (twin s) es ->
  edge_list (x :: es).
Proof.
rewrite /edge_list => es_uniq; rewrite /= mem_cat negb_or => /andP[x_es x_tes].
have tx_es : twin s x \notin es.
  by apply: contra x_tes => tx; rewrite -(twinK wf x) map_f.
have tx_tes : twin s x \notin map (twin s) es by rewrite mem_map //; apply: twin_inj.
rewrite mem_cat inE !negb_or x_es (twin_neq' wf) x_tes /=.
rewrite -[_ :: map _ _]/([:: twin s x] ++ _) uniq_catCA /= mem_cat negb_or tx_es tx_tes.
exact: es_uniq.
Qed.

Lemma edge_list_tail y es : edge_list (y :: es) ->
  [/\ edge_list es, y \notin es ++ map (twin s) es & twin s y \notin es ++ map (twin s) es].
Proof.
rewrite /edge_list /= -[twin s y :: _]/([:: twin s y] ++ _) uniq_catCA /= mem_cat inE !negb_or.
by rewrite mem_cat negb_or => /andP[/and3P[y_es _ y_tes] /andP[ty u]]; rewrite mem_cat negb_or y_es.
Qed.

Lemma in_edge_list y es x : (x \in (y :: es) ++ map (twin s) (y :: es)) =
  [|| x == y, x == twin s y | x \in es ++ map (twin s) es].
Proof. by rewrite !mem_cat !inE; case: (x == y) => //=; rewrite orbCA. Qed.

Lemma put_inE es : edge_list es -> forall x,
  put_in es x = next s (if x \in es ++ map (twin s) es then twin s x else x).
Proof.
elim: es => [|y es IHes] //= /edge_list_tail[es_ok y_out ty_out] x.
rewrite permM [LHS]IHes // in_edge_list.
have [->|xy] := eqVneq x y; first by rewrite tpermL (negbTE ty_out).
have [->|xty] := eqVneq x (twin s y); first by rewrite tpermR (negbTE y_out) twinK.
by rewrite tpermD // eq_sym.
Qed.

(* There are as many edges as can be put in. *)
Lemma size_doubled es : size (es ++ map (twin s) es) = size es * 2.
Proof. by rewrite size_cat size_map addnn muln2. Qed.

Lemma all_put_in es x : edge_list es -> size es = edges s -> x \in es ++ map (twin s) es.
Proof.
move=> es_ok size_es; apply: contraT => x_out; set l := es ++ _ in x_out.
have xl_ok : uniq (x :: l) by rewrite /= x_out.
have := max_card (mem (x :: l)); rewrite (card_uniqP xl_ok) /= size_doubled size_es edges2 //.
by rewrite ltnn.
Qed.

Lemma room es : edge_list es -> size es < edges s -> exists x, x \notin es ++ map (twin s) es.
Proof.
move=> es_ok small; apply/existsP; apply: contraLR small; rewrite negb_exists => /forallP all_in.
rewrite -leqNgt -(leq_pmul2r (isT : 0 < 2)) edges2 // -size_doubled -(card_uniqP es_ok).
by apply/subset_leq_card/subsetP => x _; apply: negbNE (all_in x).
Qed.

(* With all edges put in, next has become sigma. *)
Lemma put_in_all es : edge_list es -> size es = edges s -> put_in es = sigma s.
Proof. by move=> ok all_es; apply/permP => x; rewrite put_inE // sigmaE all_put_in. Qed.

Lemma twin_put_in es x :
  (twin s x \in es ++ map (twin s) es) = (x \in es ++ map (twin s) es).
Proof.
have tw_map y : (twin s y \in map (twin s) es) = (y \in es) := mem_map (@twin_inj _ _ s) es y.
have map_tw : (x \in map (twin s) es) = (twin s x \in es) by rewrite -tw_map twinK.
by rewrite !mem_cat tw_map map_tw orbC.
Qed.

(* As long as there is more than one orbit, some edge joins two. *)
Lemma joining_edge es : edge_list es -> 1 < #|porbits (put_in es)| ->
  exists x, twin s x \notin porbit (put_in es) x.
Proof.
move=> es_ok many; apply/existsP; apply: contraLR many.
rewrite negb_exists -leqNgt => /forallP all_in; set p := put_in es in all_in *.
have tw x : twin s x \in porbit p x by apply: negbNE (all_in x).
have nx x : next s x \in porbit p x.
  have := put_inE es_ok; rewrite -/p => pE; case in_x : (x \in es ++ map (twin s) es).
    have := porbit_step p (twin s x); rewrite pE twin_put_in in_x twinK //.
    by move: (tw x); rewrite -!eq_porbit_mem => /eqP-> /eqP->.
  by have := porbit_step p x; rewrite pE in_x.
have all_x0 x : x \in porbit p x0.
  apply: (@connected_all _ _ s con (mem (porbit p x0)) x0) => [|y y_in|y y_in] /=.
  - exact: porbit_id.
  - by move: y_in (tw y); rewrite /= -!eq_porbit_mem => /eqP<- /eqP->.
  - by move: y_in (nx y); rewrite /= -!eq_porbit_mem => /eqP<- /eqP->.
rewrite -(cards1 (porbit p x0)); apply/subset_leq_card/subsetP => A /imsetP[x _ ->].
by rewrite inE eq_porbit_mem.
Qed.

(* The first edges: each joins two orbits. *)
Lemma first_edges k : k < faces s -> exists es,
  [/\ edge_list es, size es = k, #|porbits (put_in es)| + k = faces s
    & forall x, x \in es -> twin s x \in porbit (put_in es) x].
Proof.
elim: k => [_|k IHk k_lt]; first by exists [::]; split; rewrite // addn0.
have [es [ok size_es count joined]] := IHk (ltnW k_lt).
have [|x x_out] := joining_edge ok.
  by rewrite -(ltn_add2r k) count add1n.
have x_new : x \notin es ++ map (twin s) es.
  rewrite mem_cat negb_or; apply/andP; split; first by apply: contra x_out => /joined.
  apply: contra x_out => /mapP[y /joined y_in ->].
  by rewrite twinK // porbit_sym.
exists (x :: es); split=> [||/=|y]; first exact: edge_list_cons.
- by rewrite /= size_es.
- by rewrite -count -(porbits_join x_out) addSnnS.
rewrite inE => /orP[/eqP->|/joined]; last exact: join_sub.
exact: join_one.
Qed.

(* The others: each makes at most one orbit more. *)
Lemma other_edges k es : edge_list es -> size es + k = edges s ->
  exists es', [/\ edge_list es', size es' = edges s
                & #|porbits (put_in es')| <= #|porbits (put_in es)| + k].
Proof.
elim: k es => [|k IHk] es ok size_es; first by exists es; rewrite -size_es !addn0.
have [|x x_out] := room ok; first by rewrite -size_es -[X in X < _]addn0 ltn_add2l.
have ok' := edge_list_cons ok x_out.
have [|es' [ok2 size2 count]] := IHk _ ok'; first by rewrite /= -size_es addSnnS.
exists es'; split=> //; apply: leq_trans count _.
by rewrite -addSnnS leq_add2r; apply: porbits_tperm_le.
Qed.

Theorem euler_inequality : vertices s + faces s <= edges s + 2.
Proof.
have faces_pos : 0 < faces s.
  by rewrite card_gt0; apply/set0Pn; exists (porbit (next s) x0); apply: imset_f.
have [|es [ok size_es count _]] := @first_edges (faces s).-1; first by rewrite prednK.
have size_le : size es <= edges s.
  rewrite -(leq_pmul2r (isT : 0 < 2)) edges2 // -size_doubled -(card_uniqP ok).
  exact: max_card.
have [|es' [ok' size' count']] := @other_edges (edges s - size es) es ok.
  by rewrite subnKC.
rewrite (put_in_all ok' size') -/(vertices s) in count'.
have one : #|porbits (put_in es)| = 1.
  by apply/eqP; rewrite -(eqn_add2r (faces s).-1) count add1n prednK.
rewrite one in count'; have -> : faces s = (size es).+1 by rewrite size_es prednK.
apply: leq_trans (leq_add count' (leqnn _)) _.
by rewrite -addnA addnS subnK // add1n addn2.
Qed.

(* The difference is even. *)
Theorem euler_even : odd (vertices s + faces s) = odd (edges s).
Proof.
have := odd_permM (twin s) (next s); rewrite /odd_perm -/(sigma s) -/(vertices s) -/(edges s).
rewrite -/(faces s) -(edges2 wf) oddM andbF /= oddD => ->.
by rewrite -addbA addbb addbF.
Qed.

(* So there is a genus. *)
Theorem connected_has_genus : exists g, has_genus s g.
Proof.
exists (edges s + 2 - (vertices s + faces s))./2; split=> //.
have even : ~~ odd (edges s + 2 - (vertices s + faces s)).
  by rewrite oddB ?euler_inequality // oddD euler_even addbF addbb.
have := odd_double_half (edges s + 2 - (vertices s + faces s)).
by rewrite (negbTE even) add0n mul2n => ->; rewrite subnKC // euler_inequality.
Qed.

End Genus.

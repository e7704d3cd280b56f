(* The pages of a book can be brought into any cyclic order.

   [exchange]: four flips exchange two pages that follow one another, and leave all others where
   they are.  With e the edge between the pages p and q: flip e (it becomes pq), then ap, then bq,
   then pq (it becomes an edge between the hubs again).  [sort]: so any cyclic order is reached. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach star book patch.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* The four faces of two pages that follow one another, as a table.  The labels 0, 1, 2, 3 are the
   hubs a and b and the pages p and q; the darts, in the order of their numbers:
     0 ab  1 bp  2 pa     3 ba  4 aq  5 qb     6 pb  7 ba  8 ap     9 qa  10 ab  11 bq.
   The edge between the two pages is 0, 3; those to the pages before and after are 7 and 10. *)
Definition two_pages : table :=
  ([:: 1; 2; 0; 4; 5; 3; 7; 8; 6; 10; 11; 9], [:: 0; 1; 2; 1; 0; 3; 2; 1; 0; 3; 0; 1]).
Definition two_pages_twin := [:: 3; 6; 8; 0; 9; 11; 1; 12; 2; 4; 12; 5].
Definition exchange_flips := [:: 0; 8; 5; 0].

(* What the four flips make of the table: the darts 0, 3 are again the edge between the two pages,
   10 has the page p beside it, and 7 the page q. *)
Definition exchanged : table :=
  ([:: 2; 11; 9; 5; 8; 6; 3; 4; 7; 0; 1; 10], [:: 0; 1; 1; 1; 0; 0; 2; 1; 3; 3; 0; 2]).

Lemma exchangedE : run 12 two_pages_twin exchange_flips two_pages = exchanged.
Proof. by vm_compute. Qed.

Lemma patch_corners (D V : finType) n tw f l (s : surface D V) T i :
    table_ok n T -> patch n tw f l s T -> i < n ->
  corners s (f i) = (l (tlabel T i), l (tlabel T (tnext T i)), l (tcorner T i)).
Proof.
move=> ok pa lt_in; have [e1 e2 _] := pa i lt_in.
have [_ e3 _] := pa _ (tnext_lt ok lt_in).
by rewrite /corners (patch_corner ok pa) // e1 e2 e3.
Qed.

Section Exchange.

Variables D V : finType.
Variables (s : surface D V) (a b p q : V).
Hypothesis gd : good s.
Hypothesis ab : a != b.
Hypothesis bk : book s a b.
Hypothesis thin : narrow s a b.
Hypothesis pq : p != q.

Let wf := good_wf gd.
Let lf := good_loopless gd.

Variable x : D.
Hypothesis cx : corners s x = (a, b, p).
Hypothesis ctx : corner s (twin s x) = q.

Let t := twin s x.
Let y := twin s (next s x).
Let z := twin s (next s t).
Definition page_dart := nth x [:: x; next s x; prev s x; t; next s t; prev s t;
  y; next s y; prev s y; z; next s z; prev s z].
Definition page_label := nth a [:: a; b; p; q].

Let pg_p : page a b p.
Proof.
have [_ n2 n3] := corners_differ wf lf x; have [e1 e2 e3] := cx.
by rewrite e1 e2 e3 in n2 n3; rewrite inE n3 eq_sym n2.
Qed.

Let pg_q : page a b q. Proof. by rewrite -ctx; apply: page_behind cx. Qed.

Lemma page_label_inj i j : i < 4 -> j < 4 -> page_label i = page_label j -> i = j.
Proof.
have un : uniq [:: a; b; p; q].
  move: pg_p pg_q; rewrite !inE => /andP[pa pb] /andP[qa qb].
  by rewrite /= !inE !negb_or ab pq !(eq_sym a, eq_sym b) pa pb qa qb.
by move=> lt_i lt_j eq_l; apply/eqP; rewrite -(nth_uniq a _ _ un) //; apply/eqP.
Qed.

(* The corners of the four faces. *)
Let ct : corners s t = (b, a, q).
Proof. by rewrite /t corners_twin // ctx; have [-> -> _] := cx. Qed.

Let cy : corners s y = (p, b, a).
Proof.
have [e1 e2 e3] := cx; rewrite /y corners_twin // e2 -/(prev s x) -/(corner s x) e3.
rewrite (corner_twin wf ab bk); first by rewrite /corner /prev (next3 wf) e1.
by rewrite -/(prev s x) -/(corner s x) e3 pg_p orbT.
Qed.

Let cz : corners s z = (q, a, b).
Proof.
have [e1 e2 e3] := ct; rewrite /z corners_twin // e2 -/(prev s t) -/(corner s t) e3.
rewrite (corner_twin wf ab bk); first by rewrite /corner /prev (next3 wf) e1.
by rewrite -/(prev s t) -/(corner s t) e3 pg_q orbT.
Qed.

Let twin_px : twin s (prev s x) = prev s y.
Proof.
have [e1 e2 e3] := cx; have [f1 f2 f3] := cy; apply: (corners_inj wf lf ab bk thin).
rewrite corners_twin // corners_prev // f1 f2 f3 prevK // e1 -/(corner s x) e3.
rewrite (corner_twin wf ab bk); last by rewrite -/(corner s x) e3 pg_p.
by rewrite /corner /prev (next3 wf) e2.
Qed.

Let twin_pt : twin s (prev s t) = prev s z.
Proof.
have [e1 e2 e3] := ct; have [f1 f2 f3] := cz; apply: (corners_inj wf lf ab bk thin).
rewrite corners_twin // corners_prev // f1 f2 f3 prevK // e1 -/(corner s t) e3.
rewrite (corner_twin wf ab bk); last by rewrite -/(corner s t) e3 pg_q.
by rewrite /corner /prev (next3 wf) e2.
Qed.

Lemma patch_two_pages : patch 12 two_pages_twin page_dart page_label s two_pages.
Proof.
have [e1 e2 e3] := cx; have [f1 f2 f3] := ct; have [g1 g2 g3] := cy; have [h1 h2 h3] := cz.
have tK := twinK wf; have pK := prevK wf.
case=> [|[|[|[|[|[|[|[|[|[|[|[|i]]]]]]]]]]]] // _; split=> [||_] /=;
  rewrite ?pK ?tK ?twin_px ?twin_pt //.
- by rewrite -[LHS]/(twin s (prev s y)) -twin_px tK.
- by rewrite -[LHS]/(twin s (prev s z)) -twin_pt tK.
Qed.

Let dart_inj i j : i < 12 -> j < 12 -> page_dart i = page_dart j -> i = j.
Proof. exact: (patch_inj (T := two_pages) page_label_inj _ _ _ _ patch_two_pages). Qed.

Let tau := tperm p q.

Lemma exchange_at : exists s', [/\ reach_in s 4 s', good s', book s' a b &
  forall u v, page_step s a b u v -> page_step s' a b (tau u) (tau v)].
Proof.
have par := patch_two_pages; have ok : table_ok 12 two_pages by [].
have ok' : table_ok 12 exchanged by [].
have [//|s' [r gd' par' tw' out']] := patch_run page_label_inj dart_inj
  (p := exchange_flips) gd _ par.
rewrite exchangedE in par'.
have out_corners w : outside 12 page_dart w -> corners s' w = corners s w.
  move=> ow; have ow1 := patch_outside_next wf ok par ow.
  have ow2 := patch_outside_next wf ok par ow1.
  have [n0 o0] := out' w ow; have [n1 o1] := out' _ ow1; have [n2 o2] := out' _ ow2.
  by rewrite /corners /corner /prev n0 n1 o0 o1 o2.
have in_corners i : i < 12 -> corners s' (page_dart i) =
    (page_label (tlabel exchanged i), page_label (tlabel exchanged (tnext exchanged i)),
     page_label (tcorner exchanged i)).
  by move=> lt_i; apply: patch_corners ok' par' lt_i.
have bk' : book s' a b.
  have faces w : at_face s' a w /\ at_face s' b w.
    case: (outsideP 12 page_dart w) => [[i lt_i ->] | ow]; rewrite /at_face.
      have [-> -> ->] := in_corners i lt_i; move: i lt_i.
      by case=> [|[|[|[|[|[|[|[|[|[|[|[|i]]]]]]]]]]]] // _; rewrite /= !eqxx ?orbT.
    have [-> -> ->] := out_corners w ow; exact: (conj (bk.1 w) (bk.2 w)).
  by split=> w; have [] := faces w.
have beside w : ~~ page a b (origin s w) -> ~~ page a b (origin s (next s w)) -> w != x -> w != t ->
    corners s' w = (origin s w, origin s (next s w), tau (corner s w)).
  move=> pg0 pg1 wx wt; case: (outsideP 12 page_dart w) => [[i lt_i def_w] | ow].
    have cw := patch_corners ok par lt_i; have cw' := in_corners i lt_i.
    move: pg0 pg1 wx wt; rewrite def_w; case: cw => -> -> ->; rewrite cw'; move: i lt_i {def_w cw'}.
    have [pa pb] := andP pg_p; have [qa qb] := andP pg_q.
    case=> [|[|[|[|[|[|[|[|[|[|[|[|i]]]]]]]]]]]] // _;
      rewrite /tcorner /tlabel /tnext /page_label /= ?pa ?pb ?qa ?qb ?eqxx // => _ _ _ _.
      by rewrite /tau tpermL.
    by rewrite /tau tpermR.
  have not_in i : i < 12 -> corners s w != corners s (page_dart i).
    move=> lt_i; apply: contra (ow i lt_i) => /eqP cw; apply/eqP.
    exact: (corners_inj wf lf ab bk thin).
  have n0 := not_in 0 isT; have n3 := not_in 3 isT; have n7 := not_in 7 isT.
  have n10 := not_in 10 isT; rewrite !(patch_corners ok par) // in n0 n3 n7 n10.
  have [pw qw] : corner s w != p /\ corner s w != q.
    case: (hub_ends wf lf pg0 pg1) => -[e1 e2]; rewrite /corners e1 e2 in n0 n3 n7 n10.
      by split; [apply: contra n0 | apply: contra n10] => /eqP->.
    by split; [apply: contra n7 | apply: contra n3] => /eqP->.
  by rewrite out_corners // /corners /tau tpermD // eq_sym.
exists s'; split=> // u v /existsP[w /andP[/eqP cw /eqP cwt]]; have [o1 o2 o3] := cw.
have hub_a : page a b a = false by rewrite inE eqxx.
have hub_b : page a b b = false by rewrite inE eqxx andbF.
apply/existsP; exists w; have [w_x | w_x] := eqVneq w x.
  have cx' : corners s' x = (a, b, q) := in_corners 0 isT.
  have [_ _ ct'] : corners s' t = (b, a, p) := in_corners 3 isT.
  rewrite w_x cx' tw' -/t ct' -o3 w_x -cwt w_x.
  by have [_ _ ->] := cx; rewrite ctx /tau tpermL tpermR !eqxx.
have wt_t : twin s w != t by rewrite (inj_eq (twin_inj (s := s))).
have w_t : w != t.
  by apply: contraNneq ab => def_w; rewrite -o1 def_w; have [-> _ _] := ct.
have wt_x : twin s w != x by apply: contraNneq w_t => def_x; rewrite /t -def_x (twinK wf).
have [_ _ cwt'] : corners s' (twin s w) = (b, a, tau v).
  by rewrite beside ?(origin_twin wf) ?(origin_next_twin wf) ?o1 ?o2 ?cwt ?hub_a ?hub_b.
by rewrite tw' cwt' beside ?o1 ?o2 ?hub_a ?hub_b ?o3 ?eqxx.
Qed.

End Exchange.

(* Four flips exchange two pages that follow one another; all else keeps its order. *)
Theorem exchange (D V : finType) (s : surface D V) (a b : V) l p q r :
    good s -> a != b -> book s a b -> narrow s a b -> page_order s a b (l ++ p :: q :: r) ->
  exists s', [/\ reach_in s 4 s', good s', book s' a b & page_order s' a b (l ++ q :: p :: r)].
Proof.
move=> gd ab bk thin [un cV cyc]; have wf := good_wf gd; have lf := good_loopless gd.
have : [&& p \notin q :: r ++ l, q \notin r ++ l & uniq (r ++ l)].
  by move: un; rewrite -(rot_uniq (size l)) rot_size_cat.
rewrite inE negb_or => /and3P[/andP[pq p_out] q_out _].
have : page_step s a b p q.
  by move: cyc; rewrite -(rot_cycle (size l)) rot_size_cat /= => /andP[].
case/existsP => x /andP[/eqP cx /eqP cq].
have [s' [reach_s' gd' bk' steps]] := exchange_at gd ab bk thin pq cx cq.
have fixed i : i \in r ++ l -> tperm p q i = i.
  by move=> i_in; apply: tpermD; [apply: contraNneq p_out | apply: contraNneq q_out] => ->.
have map_order : [seq tperm p q i | i <- l ++ p :: q :: r] = l ++ q :: p :: r.
  rewrite map_cat /= tpermL tpermR; congr (_ ++ _ :: _ :: _);
    by apply: map_id_in => i i_in; rewrite fixed // mem_cat i_in ?orbT.
exists s'; split=> //; rewrite -map_order; split.
- by rewrite map_inj_uniq //; apply: perm_inj.
- move=> i; rewrite -cV map_order; apply: perm_mem.
  by rewrite perm_cat2l (perm_catCA [:: q] [:: p] r).
- by rewrite cycle_map; apply: sub_cycle cyc; apply: steps.
Qed.

(* Exchanges of neighbours lead to every order. *)
Lemma neighbour_exchanges (T : eqType) (k : nat) (P : nat -> seq T -> Prop) :
    (forall n l p q r, P n (l ++ p :: q :: r) -> P (n + k) (l ++ q :: p :: r)) ->
  forall c c' n, perm_eq c c' -> P n c -> exists2 m, m <= n + k * 'C(size c, 2) & P m c'.
Proof.
move=> exch.
have front l pre x r n : P n (pre ++ l ++ x :: r) -> P (n + k * size l) (pre ++ x :: l ++ r).
  elim/last_ind: l r n => [|l y IHl] r n; first by rewrite muln0 addn0.
  rewrite -cats1 -catA catA /= => /exch; rewrite -catA => /IHl.
  by rewrite size_cat addn1 mulnS addnA -catA.
have any c' pre c n : perm_eq c c' -> P n (pre ++ c) ->
    exists2 m, m <= n + k * 'C(size c, 2) & P m (pre ++ c').
  elim: c' pre c n => [|x c' IHc] pre c n.
    by move/perm_nilP=> -> Pn; exists n; rewrite ?leq_addr.
  move=> perm_c; have: x \in c by rewrite (perm_mem perm_c) mem_head.
  move=> x_in; have [l [r def_c]] : exists l r, c = l ++ x :: r.
    by case/splitPr: x_in => l r; exists l, r.
  rewrite def_c in perm_c *; move/front; rewrite -cat_rcons => P_front.
  have perm_lr : perm_eq (l ++ r) c' by rewrite -(perm_cons x) -(perm_catCA l [:: x]).
  have [m le_m Pm] := IHc _ _ _ perm_lr P_front; exists m; last by rewrite -cat_rcons.
  apply: leq_trans le_m _; rewrite -addnA leq_add2l -mulnDr leq_mul2l.
  by rewrite !size_cat /= addnS binS bin1 [X in _ <= X]addnC leq_add2r leq_addr orbT.
by move=> c c' n perm_c Pn; apply: (any c' [::]).
Qed.

(* The pages of a book on the sphere are vertices of degree two. *)
Lemma book_narrow (D V : finType) (s : surface D V) (a b : V) :
  good s -> sphere s -> a != b -> book s a b -> narrow s a b.
Proof. by move=> gd sph ab bk p /andP[pa pb]; apply: book_pages gd sph ab bk p pa pb. Qed.

(* Any cyclic order of the pages is reached, with four flips for each exchange of neighbours. *)
Theorem sort (D V : finType) (s : surface D V) (a b : V) c c' :
    good s -> sphere s -> a != b -> book s a b -> page_order s a b c -> perm_eq c c' ->
  exists n s', [/\ n <= 4 * 'C(size c, 2), reach_in s n s', book s' a b & page_order s' a b c'].
Proof.
move=> gd sph ab bk order_c perm_c.
pose P n d := exists s', [/\ reach_in s n s', book s' a b & page_order s' a b d].
have [||m le_m [s' [r bk' order']]] := @neighbour_exchanges _ 4 P _ c c' 0 perm_c.
- move=> n l p q r [s1 [r1 bk1 order1]].
  have gd1 := reach_in_good r1 gd; have sph1 := reach_in_sphere r1 gd sph.
  have [s2 [r2 gd2 bk2 order2]] := exchange gd1 ab bk1 (book_narrow gd1 sph1 ab bk1) order1.
  by exists s2; split=> //; apply: reach_in_trans r1 r2.
- by exists s; split=> //; apply: reach_in0.
by exists m, s'.
Qed.

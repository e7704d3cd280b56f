(* Theorem 4.3 with few flips: O(V log V).

   The walk round a hub of a book goes to each page and back ([book_contour]); the pages of the one
   surface are sorted by merging into the path in the order of the other's, whose pages become
   the same path in one go; the walks are then the same, and so are the surfaces. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants order reach hub star book equal_books.
From Tightflip Require Import sorting connected contour rehang merging.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section BookContour.

Variables D V : finType.
Variables (s : surface D V) (a b : V).
Hypothesis gd : good s.
Hypothesis sph : sphere s.
Hypothesis ab : a != b.
Hypothesis bk : book s a b.

Let wf := good_wf gd.
Let lf := good_loopless gd.

Lemma step_to_page p : page a b p -> link_step s a (b, p) (p, b).
Proof.
move=> pg; have [x cx] := page_face wf ab bk pg; have [ox nx kx] := cx.
have [o n k] : corners s (prev s x) = (p, a, b) by rewrite corners_prev // ox nx kx.
apply/existsP; exists (prev s x); rewrite n o k eqxx /=.
by rewrite (corner_twin wf ab bk) ?k ?eqxx // o pg.
Qed.

Lemma step_from_page p q : page_step s a b q p -> link_step s a (p, b) (b, q).
Proof.
case/existsP => x /andP[/eqP[ox nx kx] /eqP kt]; apply/existsP; exists (twin s x).
by rewrite (origin_next_twin wf) (origin_twin wf) (twinK wf) ox nx kx kt !eqxx.
Qed.

Lemma walk_to_pages l p q : {in l, forall r, page a b r} ->
    path (fun r r' => page_step s a b r' r) p (rcons l q) ->
  path (link_step s a) (p, b) (rcons (legs b l) (b, q)).
Proof.
elim: l p => [|r l IHl] p pages /=; first by rewrite !andbT => /step_from_page.
case/andP=> /step_from_page-> walk; rewrite step_to_page ?pages ?mem_head //=.
by apply: IHl walk => r' r'l; apply: pages; rewrite in_cons r'l orbT.
Qed.

Theorem book_contour c : page_order s a b c -> contour s a (legs b (rev c)).
Proof.
move=> order_c; have [un cV cyc] := order_c; split.
- by apply: legs_uniq; rewrite /= mem_rev rev_uniq un andbT cV inE eqxx andbF.
- move: cyc; rewrite -rev_cycle; have: {in rev c, forall p, page a b p}.
    by move=> p; rewrite mem_rev cV.
  case: (rev c) => // p l pages walk; rewrite /= step_to_page; last first.
    by apply: pages; apply: mem_head.
  by apply: walk_to_pages walk => r rl; apply: pages; rewrite in_cons rl orbT.
rewrite size_legs size_rev (size_page_order ab order_c) (card_opposite gd bk.1).
by have := sphere_faces wf sph; rewrite mulnBr => <-; rewrite addnK.
Qed.

End BookContour.

Lemma total_index (V : eqType) (l : seq V) : total (fun x y => index x l <= index y l).
Proof. by move=> x y; apply: leq_total. Qed.

(* Two loopless triangulations of the sphere with the same V labels are joined by at most
   2 (V - 2) k + 8 V - 24 flips, where k is the logarithm of V - 2 to the base 2, rounded up. *)
Theorem theorem_4_3_short (D D' V : finType) (s : surface D V) (s' : surface D' V) :
    good s -> good s' -> sphere s -> sphere s' ->
  exists2 n, joined_in s n s' & n + 24 <= 2 * (#|V| - 2) * up_log 2 (#|V| - 2) + 8 * #|V|.
Proof.
move=> gd gd' sph sph'; set k := up_log 2 _.
have le_k : #|V| - 2 <= 2 ^ k by apply: up_logP.
have [[a b] /= ab] := sphere_hubs gd sph.
have [n [t [c [r bk order_c le_n]]]] := to_book gd sph ab.
have [n' [t' [c' [r' bk' order_c' le_n']]]] := to_book gd' sph' ab.
have gdt := reach_in_good r gd; have gdt' := reach_in_good r' gd'.
have spht := reach_in_sphere r gd sph; have spht' := reach_in_sphere r' gd' sph'.
have con := book_contour gdt spht ab bk order_c.
have con' := book_contour gdt' spht' ab bk' order_c'.
have sz := size_page_order ab order_c; have sz' := size_page_order ab order_c'.
have [un cV _] := order_c; have [un' cV' _] := order_c'.
pose l := rev c; pose l' := rev c'.
have perm_l : perm_eq l l'.
  by apply: uniq_perm; rewrite ?rev_uniq // => p; rewrite !mem_rev cV cV'.
have b_out m : m =i page a b -> b \notin m by move=> mV; rewrite mV inE eqxx andbF.
have un_l : uniq (b :: l) by rewrite /= rev_uniq un mem_rev b_out.
have un_l' : uniq (b :: l') by rewrite /= rev_uniq un' mem_rev b_out.
have no_fresh m : fresh m ([::] ++ [::] : seq (V * V)) by [].
pose leT x y := index x l' <= index y l'.
have le_l : size l <= 2 ^ k by rewrite size_rev sz.
have [|m [u [le_m ru gdu hubu conu]]] :=
  @sort_legs _ _ a leT k t [::] [::] b l le_l gdt bk.1 un_l (no_fresh _).
  by rewrite cats0.
have [|m' [u' [le_m' ru' gdu' hubu' conu']]] :=
  @chain_legs _ _ a t' [::] [::] b l' gdt' bk'.1 un_l' (no_fresh _).
  by rewrite cats0.
have def_l' : msort leT k l = l'.
  apply: sorted_index; first by case/andP: un_l'.
    by rewrite (permPl (perm_msort leT k l)).
  by apply: msort_sorted le_l; apply: total_index.
rewrite def_l' !cats0 in conu conu'.
have same : same_surface u u'.
  by case: gdu gdu' => wf lf _ [wf' lf' _]; apply: equal_contours hubu hubu' conu conu'.
have there : joined_in s (n + m) u' by exists u; first exact: reach_in_trans r ru.
have back : joined_in u' (n' + m') s'.
  apply: joined_in_sym => //; exists u'; first exact: reach_in_trans r' ru'.
  exact: same_surface_refl.
exists (n + m + (n' + m')); first exact: joined_in_trans there back.
rewrite !size_rev sz sz' in le_m le_m'; have le_w := pred_le le_k.
have -> : n + m + (n' + m') + 24 = (m + m') + (n + 12 + (n' + 12)).
  by rewrite addnACA -addnA [_ + 24]addnC addnA [in RHS](addnACA n) addnC.
apply: leq_add; last by rewrite -[8]/(4 + 4) mulnDl; apply: leq_add.
apply: leq_trans (leq_add le_m le_m') _; rewrite -mulnDr subnK //.
by rewrite -mulnA leq_mul2l /= mulnC.
Qed.

(* Pages of a book merged into one path, in any order, by few flips.

   [leg u p]: the walk from u along the path p and back.  Where two legs at u follow one another,
   they are merged into one with two flips for each of their vertices but the last ([merge_legs]);
   so up to 2^k single legs are sorted into one path by k rounds of merging ([sort_legs]). *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach contour rehang.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Legs.

Variable V : eqType.
Implicit Types (u v : V) (p q l : seq V) (e : V * V) (pre post : seq (V * V)).

Fixpoint leg u p := if p is v :: p' then (u, v) :: leg v p' ++ [:: (v, u)] else [::].

(* An edge of a leg has an end on the path, and the other one there or at u. *)
Lemma leg_ends u p e : e \in leg u p ->
  [/\ e.1 \in u :: p, e.2 \in u :: p & (e.1 \in p) || (e.2 \in p)].
Proof.
elim: p u => //= v p IHp u; rewrite (in_cons (u, v)) mem_cat mem_seq1.
case/or3P=> [/eqP->|/IHp[e1 e2 _]|/eqP->].
- by rewrite /= !in_cons !eqxx ?orbT.
- by rewrite !(in_cons u) e1 e2 !orbT.
by rewrite /= !in_cons !eqxx ?orbT.
Qed.

(* The edges elsewhere do not touch the vertices in l. *)
Definition fresh l pre := forall e, e \in pre -> e.1 \notin l /\ e.2 \notin l.

Lemma leg_fresh u p l : {in l, forall v, v \notin u :: p} -> fresh l (leg u p).
Proof.
move=> apart e /leg_ends[e1 e2 _].
by split; apply/negP => /apart; rewrite ?e1 ?e2.
Qed.

Lemma fresh_leg_out u p e : e.1 \notin p -> e.2 \notin p -> e \notin leg u p.
Proof. by move=> e1 e2; apply/negP => /leg_ends[_ _]; rewrite (negbTE e1) (negbTE e2). Qed.

Lemma leg_uniq u p : uniq (u :: p) -> uniq (leg u p).
Proof.
elim: p u => //= v p IHp u; rewrite in_cons negb_or -andbA => /and4P[uv up vp unp].
have un : uniq (leg v p) by apply: IHp; rewrite /= vp.
have out e : (e.1 == u) || (e.2 == u) -> e \notin leg v p.
  move=> eu; apply/negP => /leg_ends[e1 e2 _]; move: e1 e2; rewrite !in_cons.
  by case/orP: eu => /eqP->; rewrite (negbTE uv) (negbTE up).
rewrite mem_cat mem_seq1 negb_or out ?eqxx // cat_uniq un /= orbF andbT.
by rewrite out ?eqxx ?orbT // andbT xpair_eqE negb_and uv.
Qed.

(* What two legs at u, one after the other, need in order to be merged. *)
Definition side_by_side pre post u p q :=
  [/\ uniq (u :: p ++ q), uniq (pre ++ post) & fresh (p ++ q) (pre ++ post)].

Lemma side_by_side_uniq pre post u p q :
  side_by_side pre post u p q -> uniq (pre ++ leg u p ++ leg u q ++ post).
Proof.
case=> /= /andP[u_out]; rewrite cat_uniq => /and3P[up pq uq] un fr.
have perm : perm_eq (pre ++ leg u p ++ leg u q ++ post) (leg u p ++ leg u q ++ pre ++ post).
  by rewrite perm_catCA perm_cat2l perm_catCA.
rewrite (perm_uniq perm) cat_uniq leg_uniq; last first.
  by rewrite /= up andbT; apply: contra u_out; rewrite mem_cat => ->.
rewrite cat_uniq leg_uniq; last first.
  by rewrite /= uq andbT; apply: contra u_out; rewrite mem_cat orbC => ->.
rewrite un /= !andbT; apply/andP; split; last first.
  apply/hasPn => e /fr; rewrite !mem_cat !negb_or => -[/andP[_ e1] /andP[_ e2]].
  exact: fresh_leg_out.
apply/hasPn => e; rewrite mem_cat => /orP[/leg_ends[e1 e2 e12] | /fr].
  have q_out v : v \in u :: q -> v \notin p.
    rewrite in_cons => /orP[/eqP->|vq]; first by apply: contra u_out; rewrite mem_cat => ->.
    by apply: contra pq => vp; apply/hasP; exists v.
  by apply: fresh_leg_out; apply: q_out.
rewrite !mem_cat !negb_or => -[/andP[e1 _] /andP[e2 _]]; exact: fresh_leg_out.
Qed.

(* The first vertex of the one leg or the other comes first: what is left is side by side. *)
Lemma side_by_side_first pre post u v p q p' q' :
    side_by_side pre post u p q -> perm_eq (v :: p' ++ q') (p ++ q) ->
  side_by_side (pre ++ [:: (u, v)]) ((v, u) :: post) v p' q'.
Proof.
case=> /= /andP[u_out un_pq] un fr perm.
have v_in : v \in p ++ q by rewrite -(perm_mem perm) mem_head.
have sub w : w \in p' ++ q' -> w \in p ++ q.
  by move=> w_in; rewrite -(perm_mem perm) in_cons w_in orbT.
have un' : uniq (v :: p' ++ q') by rewrite (perm_uniq perm).
have uv : u != v by apply: contraNneq u_out => ->.
split=> //.
  rewrite -catA /=; have out e : (e.1 == v) || (e.2 == v) -> e \notin pre ++ post.
    by move=> ev; apply/negP => /fr[e1 e2]; case/orP: ev => /eqP ev; rewrite ev v_in in e1 e2.
  have perm' : perm_eq (pre ++ (u, v) :: (v, u) :: post) ((u, v) :: (v, u) :: pre ++ post).
    by rewrite (perm_catCA pre [:: (u, v); (v, u)]).
  rewrite (perm_uniq perm') !cons_uniq un in_cons negb_or !out ?eqxx ?orbT //.
  by rewrite xpair_eqE negb_and uv.
have v_out : v \notin p' ++ q' by case/andP: un'.
have u_out' : u \notin p' ++ q' by apply: contra u_out; apply: sub.
move=> e e_in; have [/eqP->|n1] := boolP (e == (u, v)); first by [].
have [/eqP->|n2] := boolP (e == (v, u)); first by [].
have /fr[e1 e2] : e \in pre ++ post.
  by move: e_in; rewrite !mem_cat mem_seq1 in_cons (negbTE n1) (negbTE n2) orbF.
by split; [apply: contra e1 | apply: contra e2]; apply: sub.
Qed.

(* Legs of one vertex each. *)
Fixpoint legs u l := if l is v :: l' then (u, v) :: (v, u) :: legs u l' else [::].

Lemma legs_cat u l1 l2 : legs u (l1 ++ l2) = legs u l1 ++ legs u l2.
Proof. by elim: l1 => //= v l1 ->. Qed.

Lemma legs_ends u l e : e \in legs u l -> e.1 \in u :: l /\ e.2 \in u :: l.
Proof.
elim: l => //= v l IHl; rewrite (in_cons (u, v)) (in_cons (v, u)).
case/or3P=> [/eqP->|/eqP->|/IHl]; rewrite /= !in_cons ?eqxx ?orbT //.
by case=> /orP[] -> /orP[] ->; rewrite ?orbT.
Qed.

Lemma legs_uniq u l : uniq (u :: l) -> uniq (legs u l).
Proof.
elim: l => //= v l IHl; rewrite in_cons negb_or -andbA => /and4P[uv ul vl unl].
have un : uniq (legs u l) by apply: IHl; rewrite /= ul.
have out e : (e.1 == v) || (e.2 == v) -> e \notin legs u l.
  move=> ev; apply/negP => /legs_ends[e1 e2]; move: e1 e2; rewrite !in_cons.
  by case/orP: ev => /eqP->; rewrite (negbTE vl) orbF [v == u]eq_sym (negbTE uv).
rewrite in_cons negb_or !out ?eqxx ?orbT // un.
by rewrite xpair_eqE negb_and uv.
Qed.

Lemma size_legs u l : size (legs u l) = 2 * size l.
Proof. by elim: l => //= v l ->; rewrite mulnS. Qed.

(* Sorting by merging, in k rounds. *)
Fixpoint msort (leT : rel V) k l :=
  if k is k'.+1 then merge leT (msort leT k' (take (2 ^ k') l)) (msort leT k' (drop (2 ^ k') l))
  else l.

Lemma perm_msort leT k l : perm_eq (msort leT k l) l.
Proof.
elim: k l => //= k IHk l; rewrite perm_merge -[X in perm_eq _ X](cat_take_drop (2 ^ k) l).
exact: perm_cat.
Qed.

Lemma msort_sorted leT k l : total leT -> size l <= 2 ^ k -> sorted leT (msort leT k l).
Proof.
move=> leT_total; elim: k l => [|k IHk] l; first by case: l => [|x []].
move=> sz /=; apply: merge_sorted => //; apply: IHk; first by rewrite size_take; case: ltnP.
by rewrite size_drop leq_subLR addnn -mul2n -expnS.
Qed.

(* What is sorted by the places in a list is that list. *)
Lemma sorted_index l l' : uniq l' -> perm_eq l l' ->
  sorted (fun x y => index x l' <= index y l') l -> l = l'.
Proof.
move=> un perm; case: l' un perm => [|x0 l0]; first by move=> _ /perm_nilP.
set l' := x0 :: l0 => un perm sorted_l.
have back m : {subset m <= l'} -> m = [seq nth x0 l' i | i <- [seq index x l' | x <- m]].
  move=> sub; rewrite -map_comp -[LHS]map_id; apply/eq_in_map => x /sub x_in.
  by rewrite /= nth_index.
have sub_l : {subset l <= l'} by move=> x; rewrite (perm_mem perm).
apply: etrans (back l sub_l) (etrans _ (esym (back l' (fun x h => h)))).
congr map; apply: (sorted_eq leq_trans anti_leq); last exact: perm_map.
  by rewrite sorted_map.
have -> : [seq index x l' | x <- l'] = iota 0 (size l').
  apply: (@eq_from_nth _ 0); rewrite size_map ?size_iota // => i lt_i.
  by rewrite (nth_map x0) // nth_iota // index_uniq.
exact: iota_sorted.
Qed.

End Legs.

(* Two flips for each vertex but the last one, where both legs have one. *)
Definition merge_cost i j := if (i == 0) || (j == 0) then 0 else 2 * (i + j).-1.

Lemma merge_costS i j : 2 + merge_cost i j.+1 <= merge_cost i.+1 j.+1.
Proof.
rewrite /merge_cost /= orbF; case: i => [|i] /=; first by rewrite addn0 mulnS leq_addr.
by rewrite !addSn mulnS.
Qed.

Lemma merge_costC i j : merge_cost i j = merge_cost j i.
Proof. by rewrite /merge_cost orbC addnC. Qed.

Lemma pred_le k n : n <= 2 ^ k -> n.-1 <= k * n.
Proof.
case: k => [|k]; first by case: n => [|[|n]].
by move=> _; apply: leq_trans (leq_pred n) (leq_pmull _ _).
Qed.

(* One round more. *)
Lemma sort_costS k i j : i.-1 <= k * i -> j.-1 <= k * j ->
  2 * (k * i - i.-1) + 2 * (k * j - j.-1) + merge_cost i j <= 2 * (k.+1 * (i + j) - (i + j).-1).
Proof.
rewrite /merge_cost -mulnDr; case: i => [|i].
  by rewrite /= muln0 sub0n !add0n addn0 leq_mul2l /= leq_sub2r // leq_mul2r leqnSn orbT.
case: j => [|j] le_i le_j.
  by rewrite orbT !addn0 muln0 sub0n !addn0 leq_mul2l /= leq_sub2r // leq_mul2r leqnSn orbT.
rewrite addSn [(_ || _)]/= -mulnDr leq_mul2l [_.+1.-1]/= [_.+1.-1]/= [_.+1.-1]/= addnACA subnK //.
rewrite addnS subnK // mulSn addSn -addnS addKn addnS -[(i + j.+1).+1]addSn mulnDr.
by rewrite leqnn orbT.
Qed.

Section Merge.

Variables D V : finType.
Variable a : V.
Variable leT : rel V.
Implicit Types (s : surface D V) (u x y : V) (p q : seq V) (c pre post : seq (V * V)).

(* At most n flips lead to a surface with the hub a and the walk c. *)
Definition walks_within s n c := exists m s',
  [/\ m <= n, reach_in s m s', good s', hub s' a & contour s' a c].

Lemma contour_rot s c1 c2 : contour s a (c1 ++ c2) -> contour s a (c2 ++ c1).
Proof.
case=> un cyc sz; split; first by rewrite uniq_catC.
  by rewrite -(rot_size_cat c1) rot_cycle.
by rewrite size_cat addnC -size_cat.
Qed.

Lemma hang_back_in s pre c post u x y : good s -> hub s a -> x != y ->
    contour s a (pre ++ (x, u) :: (u, y) :: c ++ (y, u) :: post) ->
    uniq (pre ++ (x, y) :: c ++ (y, x) :: (x, u) :: post) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a (pre ++ (x, y) :: c ++ (y, x) :: (x, u) :: post)].
Proof.
move=> gd hub_a xy /contour_rot; rewrite /= -catA /= => con un.
have [|s' [r gd' hub' con']] := hang_back gd hub_a xy con.
  by move: un; rewrite uniq_catC /= -catA.
exists s'; split=> //; apply: contour_rot.
by rewrite /= -catA.
Qed.

Lemma hang_on_in s pre c post u x y : good s -> hub s a -> x != y ->
    contour s a (pre ++ (u, y) :: c ++ (y, u) :: (u, x) :: post) ->
    uniq (pre ++ (u, x) :: (x, y) :: c ++ (y, x) :: post) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a (pre ++ (u, x) :: (x, y) :: c ++ (y, x) :: post)].
Proof.
move=> gd hub_a xy /contour_rot; rewrite /= -catA /= => con un.
have [|s' [r gd' hub' con']] := hang_on gd hub_a xy con.
  by move: un; rewrite uniq_catC /= -catA.
exists s'; split=> //; apply: contour_rot.
by rewrite /= -catA.
Qed.

Theorem merge_legs s pre post u p q : good s -> hub s a ->
    side_by_side pre post u p q -> contour s a (pre ++ leg u p ++ leg u q ++ post) ->
  walks_within s (merge_cost (size p) (size q)) (pre ++ leg u (merge leT p q) ++ post).
Proof.
have [k] := ubnP (size p + size q).
elim: k s pre post u p q => // k IHk s pre post u [|x p] [|y q] le_k gd hub_a side con.
- by exists 0, s; split=> //; apply: reach_in0.
- by exists 0, s; split=> //; apply: reach_in0.
- by exists 0, s; split=> //; apply: reach_in0.
have [un un_pp fr] := side; have xy : x != y.
  case/and3P: un => _ x_out _; apply: contraNneq x_out => ->.
  by rewrite mem_cat mem_head orbT.
rewrite /=; case: ifP => _.
  have side' : side_by_side (pre ++ [:: (u, x)]) ((x, u) :: post) x p (y :: q).
    exact: side_by_side_first side (perm_refl _).
  have un' := side_by_side_uniq side'.
  have [||s1 [r1 gd1 hub1 con1]] :=
    @hang_back_in s (pre ++ (u, x) :: leg x p) (leg y q) post u x y gd hub_a xy.
  - by move: con; rewrite /= -?catA /= -?catA.
  - by move: un'; rewrite /= -?catA /= -?catA.
  have [||m [s2 [le_m r2 gd2 hub2 con2]]] := IHk s1 _ _ _ p (y :: q) _ gd1 hub1 side'.
  - by move: le_k; rewrite /= addSn.
  - by move: con1; rewrite /= -?catA /= -?catA.
  exists (2 + m), s2; split=> //.
  - by apply: leq_trans _ (merge_costS _ _); rewrite leq_add2l.
  - exact: reach_in_trans r1 r2.
  by move: con2; rewrite /= -?catA.
have side' : side_by_side (pre ++ [:: (u, y)]) ((y, u) :: post) y (x :: p) q.
  by apply: side_by_side_first side _; rewrite (perm_catCA [:: y] (x :: p) q).
have un' := side_by_side_uniq side'.
have [|||s1 [r1 gd1 hub1 con1]] :=
  @hang_on_in s pre (leg x p) (leg y q ++ (y, u) :: post) u y x gd hub_a.
- by rewrite eq_sym.
- by move: con; rewrite /= -?catA /= -?catA.
- by move: un'; rewrite /= -?catA /= -?catA.
have [||m [s2 [le_m r2 gd2 hub2 con2]]] := IHk s1 _ _ _ (x :: p) q _ gd1 hub1 side'.
- by move: le_k; rewrite /= addnS.
- by move: con1; rewrite /= -?catA /= -?catA.
exists (2 + m), s2; split=> //.
- rewrite merge_costC; apply: leq_trans _ (merge_costS _ _).
  by rewrite leq_add2l merge_costC.
- exact: reach_in_trans r1 r2.
by move: con2; rewrite /= -?catA.
Qed.

(* Single legs are merged into one, sorted, in k rounds of two flips for each vertex, less two for
   each vertex but one. *)
Theorem sort_legs k s pre post u l : size l <= 2 ^ k -> good s -> hub s a ->
    uniq (u :: l) -> fresh l (pre ++ post) -> contour s a (pre ++ legs u l ++ post) ->
  walks_within s (2 * (k * size l - (size l).-1)) (pre ++ leg u (msort leT k l) ++ post).
Proof.
elim: k s pre post l => [|k IHk] s pre post l sz gd hub_a un fr con.
  exists 0, s; split=> //; first exact: reach_in0.
  by case: l sz {un fr} con => [|x []].
pose l1 := take (2 ^ k) l; pose l2 := drop (2 ^ k) l; pose m1 := msort leT k l1.
have def_l : l = l1 ++ l2 by rewrite cat_take_drop.
have sz1 : size l1 <= 2 ^ k by rewrite size_take; case: ltnP.
have sz2 : size l2 <= 2 ^ k by rewrite size_drop leq_subLR addnn -mul2n -expnS.
have perm_m1 := perm_msort leT k l1; have perm_m2 := perm_msort leT k l2.
have [u_out un_l] : u \notin l /\ uniq l by case/andP: un.
have [un1 un12 un2] : [/\ uniq l1, {in l1, forall x, x \notin l2} & uniq l2].
  move: un_l; rewrite def_l cat_uniq => /and3P[-> /hasPn no ->]; split=> // x x1.
  by apply/negP => /no /=; rewrite x1.
have sub1 : {subset l1 <= l} by move=> x; rewrite def_l mem_cat => ->.
have sub2 : {subset l2 <= l} by move=> x; rewrite def_l mem_cat orbC => ->.
have u1 : u \notin l1 by apply: contra u_out; apply: sub1.
have u2 : u \notin l2 by apply: contra u_out; apply: sub2.
have fresh_sub m c : {subset m <= l} -> fresh m (pre ++ post) by
  move=> sub e /fr[e1 e2]; split; [apply: contra e1 | apply: contra e2]; apply: sub.
have [|||m [s1 [le_m r1 gd1 hub1 con1]]] :=
  IHk s pre (legs u l2 ++ post) l1 sz1 gd hub_a.
- by rewrite /= u1.
- move=> e; rewrite !mem_cat orbCA => /orP[/legs_ends[]|e_in]; last first.
    by apply: (fresh_sub l1 pre sub1); rewrite mem_cat.
  rewrite !in_cons => e1 e2; split.
    by case/orP: e1 => [/eqP->//|e1]; apply/negP => /un12; rewrite e1.
  by case/orP: e2 => [/eqP->//|e2]; apply/negP => /un12; rewrite e2.
- by move: con; rewrite def_l legs_cat -?catA.
have [|||m' [s2 [le_m' r2 gd2 hub2 con2]]] := IHk s1 (pre ++ leg u m1) post l2 sz2 gd1 hub1.
- by rewrite /= u2.
- move=> e; rewrite -catA !mem_cat orbCA => /orP[/leg_ends[e1 e2 _]|e_in]; last first.
    by apply: (fresh_sub l2 pre sub2); rewrite mem_cat.
  move: e1 e2; rewrite !in_cons !(perm_mem perm_m1) => e1 e2; split.
    by case/orP: e1 => [/eqP->//|/un12].
  by case/orP: e2 => [/eqP->//|/un12].
- by move: con1; rewrite -?catA.
have [un_c _ _] := con2; rewrite -catA in con2.
have perm_m : perm_eq (m1 ++ msort leT k l2) l by rewrite def_l perm_cat.
have side : side_by_side pre post u m1 (msort leT k l2).
  split.
  - by rewrite /= (perm_mem perm_m) (perm_uniq perm_m) u_out.
  - apply: subseq_uniq un_c; rewrite -catA; apply: cat_subseq => //.
    exact: subseq_trans (suffix_subseq _ _) (suffix_subseq _ _).
  by move=> e /fr; rewrite !(perm_mem perm_m).
have [n [s3 [le_n r3 gd3 hub3 con3]]] := merge_legs gd2 hub2 side con2.
exists (m + m' + n), s3; split=> //.
  rewrite (perm_size perm_m1) (perm_size perm_m2) in le_n; rewrite def_l size_cat.
  apply: leq_trans (sort_costS (pred_le sz1) (pred_le sz2)).
  by rewrite !leq_add.
exact: reach_in_trans (reach_in_trans r1 r2) r3.
Qed.

(* Single legs become one path in their order, with two flips for each vertex but one. *)
Theorem chain_legs s pre post u l : good s -> hub s a ->
    uniq (u :: l) -> fresh l (pre ++ post) -> contour s a (pre ++ legs u l ++ post) ->
  walks_within s (2 * (size l).-1) (pre ++ leg u l ++ post).
Proof.
elim: l s pre post => [|v l IHl] s pre post gd hub_a un fr con.
  by exists 0, s; split=> //; apply: reach_in0.
have [u_out v_out un_l] : [/\ u \notin v :: l, v \notin l & uniq l] by case/and3P: un.
have [uv ul] : u != v /\ u \notin l by move: u_out; rewrite in_cons negb_or => /andP[].
have [un_c _ _] := con; have fr_l : fresh l (pre ++ post).
  by move=> e /fr; rewrite !in_cons !negb_or => -[/andP[_ ->] /andP[_ ->]].
have [|||m [s1 [le_m r1 gd1 hub1 con1]]] := IHl s (pre ++ [:: (u, v); (v, u)]) post gd hub_a.
- by rewrite /= ul.
- move=> e; rewrite -catA !mem_cat orbCA => /orP[|e_in]; last first.
    by apply: fr_l; rewrite mem_cat.
  by rewrite !in_cons orbF => /orP[] /eqP->.
- by move: con; rewrite -catA.
rewrite -catA /= in con1; case: l {IHl} le_m fr un u_out v_out un_l ul fr_l con con1 un_c.
  by move=> le_m _ _ _ _ _ _ _ _ con1 _; exists m, s1.
move=> w l le_m fr un u_out v_out un_l ul fr_l con con1 un_c.
have side : side_by_side pre post u [:: v] (w :: l).
  split=> //; apply: subseq_uniq un_c; apply: cat_subseq => //; exact: suffix_subseq.
have side1 := side_by_side_first side (perm_refl (v :: [::] ++ w :: l)).
have un1 := side_by_side_uniq side1.
have vw : v != w by move: v_out; rewrite in_cons negb_or => /andP[].
have [||s2 [r2 gd2 hub2 con2]] :=
  @hang_back_in s1 (pre ++ [:: (u, v)]) (leg w l) post u v w gd1 hub1 vw.
- by move: con1; rewrite /= -?catA.
- by move: un1; rewrite /= -?catA /= -?catA.
exists (m + 2), s2; split=> //.
- by rewrite /= mulnS addnC leq_add2l.
- exact: reach_in_trans r1 r2.
by move: con2; rewrite /= -?catA /= -?catA.
Qed.

End Merge.

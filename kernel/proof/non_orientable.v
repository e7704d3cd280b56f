(* Two surfaces that are not orientable, found to be what is said by calculation: the projective
   plane with six vertices, in which each two are joined by one edge ([projective_plane]), and a
   Klein bottle with four vertices ([klein_bottle]).  So Theorem 4.2 for signed surfaces does not
   speak of orientable ones only: in each of these some edge may be flipped, and what any flips
   lead to is not orientable ([signed_reach_not_orientable]). *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.
From Tightflip Require Import surface flip signed orientability.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Going from dart to dart: true leads to the next one, false to the twin; and the parity of the
   reversed sides that are crossed. *)
Section Walk.

Variables D V : finType.
Variable s : signed D V.

Fixpoint walk (w : seq bool) x :=
  if w is c :: w' then walk w' (if c then next (base s) x else twin (base s) x) else x.

Fixpoint parity (w : seq bool) x :=
  if w is c :: w' then
    if c then parity w' (next (base s) x) else reversed s x (+) parity w' (twin (base s) x)
  else false.

(* A way round that crosses an odd number of reversed sides forbids every orientation. *)
Lemma odd_way_not_orientable w x : walk w x = x -> parity w x -> ~ orientable s.
Proof.
move=> back odd_w [o [o_next o_twin]].
have o_walk u y : o (walk u y) = o y (+) parity u y.
  elim: u y => [|[] u IHu] y /=; rewrite ?addbF // IHu ?o_next // o_twin addbA //.
by have := o_walk w x; rewrite back odd_w; case: (o x).
Qed.

End Walk.

(* What any number of flips leads to from a signed surface. *)
Inductive signed_reach (D V : finType) (s : signed D V) : signed D V -> Prop :=
| signed_reach0 : signed_reach s s
| signed_reachS h s' : allowed (base s) h -> signed_reach (signed_flip h s) s' -> signed_reach s s'.

Theorem signed_reach_not_orientable (D V : finType) (s s' : signed D V) :
  signed_well_formed s -> signed_reach s s' -> ~ orientable s -> ~ orientable s'.
Proof.
move=> wf r; elim: r wf => {s s'} // s h s' al _ IH wf no.
have hap := signed_allowed_apart wf al.
by apply: IH; [apply: signed_flip_well_formed | rewrite signed_flip_orientable].
Qed.

(* Surfaces from tables: dart i has the twin i + 1 or i - 1, whichever belongs to its pair, and the
   table has next, origin and reversed of each dart.  The vertices are 0 to m. *)
Section Table.

Variables (n m : nat) (table : seq (nat * nat * bool)).

Let entry i := nth (0, 0, false) table i.
Let tw i := if odd i then i.-1 else i.+1.
Let nx i := (entry i).1.1.
Let og i := (entry i).1.2.
Let rv i := (entry i).2.

(* The double cover: next, turning about the vertex, label, the other dart of the same corner. *)
Let cnx (z : nat * bool) := (if z.2 then nx (nx z.1) else nx z.1, z.2).
Let cturn (z : nat * bool) := cnx (tw z.1, z.2 (+) rv z.1).
Let clab (z : nat * bool) := og (if z.2 then nx z.1 else z.1).
Let caround (z : nat * bool) := cnx (z.1, ~~ z.2).

(* All darts that are reached from dart i in k rounds. *)
Fixpoint reached k (xs : seq nat) :=
  if k is k'.+1 then reached k' (undup (xs ++ map tw xs ++ map nx xs)) else xs.

Let darts := iota 0 n.+1.
Let cover := [seq (k, false) | k <- darts] ++ [seq (k, true) | k <- darts].

(* Everything is in order, by calculation; all darts are reached in so many rounds. *)
Definition signed_table_ok rounds :=
  [&& all (fun i => [&& tw i <= n, nx i <= n & og i <= m]) darts,
      all (fun i => [&& nx (nx (nx i)) == i, nx i != i, rv (tw i) == rv i & og i != og (nx i)])
        darts,
      all (fun z => let orbit := traject cturn z n in
                    let other := traject cturn (caround z) n in
                    (clab (cturn z) == clab z) &&
                    all (fun w => (clab z == clab w) ==> (w \in orbit) || (w \in other)) cover)
        cover,
      all (fun v => has (fun i => og i == v) darts) (iota 0 m.+1) &
      all (fun i => let xs := reached rounds [:: i] in all (mem xs) darts) darts].

Variable rounds : nat.
Hypothesis ok : signed_table_ok rounds.

Implicit Types i j : 'I_n.+1.

Let dart i : val i \in darts. Proof. by rewrite mem_iota ltn_ord. Qed.

Let in_range i : [/\ tw i <= n, nx i <= n & og i <= m].
Proof. by have [/allP/(_ _ (dart i))/and3P] := and5P ok. Qed.

Let entry_ok i : [/\ nx (nx (nx i)) = i, nx i != i, rv (tw i) = rv i & og i != og (nx i)].
Proof. by have [_ /allP/(_ _ (dart i))/and4P[/eqP ? ? /eqP ? ?]] := and5P ok. Qed.

Let tw_tw k : tw (tw k) = k.
Proof.
rewrite /tw; case odd_k: (odd k); last by rewrite /= odd_k.
by case: k odd_k => //= k /negbTE->.
Qed.

Let tw_neq k : tw k != k.
Proof.
rewrite /tw; case: ifP => [|_]; last by rewrite neq_ltn ltnSn orbT.
by case: k => // k _; rewrite neq_ltn ltnSn.
Qed.

Let twin_of i : 'I_n.+1 := inord (tw i).
Let next_of i : 'I_n.+1 := inord (nx i).

Let twin_ofE i : val (twin_of i) = tw i.
Proof. by have [? _ _] := in_range i; rewrite /= inordK. Qed.
Let next_ofE i : val (next_of i) = nx i.
Proof. by have [_ ? _] := in_range i; rewrite /= inordK. Qed.

Let twin_of_inj : injective twin_of.
Proof. by apply: (can_inj (g := twin_of)) => i; apply: val_inj; rewrite !twin_ofE tw_tw. Qed.
Let next_of_inj : injective next_of.
Proof.
apply: (can_inj (g := fun i => next_of (next_of i))) => i; apply: val_inj.
by rewrite !next_ofE; have [-> _ _ _] := entry_ok i.
Qed.

Definition table_signed : signed [finType of 'I_n.+1] [finType of 'I_m.+1] :=
  Signed (Surface (perm twin_of_inj) (perm next_of_inj) [ffun i : 'I_n.+1 => inord (og i)])
         [ffun i : 'I_n.+1 => rv i].

Let s := table_signed.

Let twinE i : val (twin (base s) i) = tw i. Proof. by rewrite permE twin_ofE. Qed.
Let nextE i : val (next (base s) i) = nx i. Proof. by rewrite permE next_ofE. Qed.
Let originE i : val (origin (base s) i) = og i.
Proof. by have [_ _ ?] := in_range i; rewrite ffunE /= inordK. Qed.
Let reversedE i : reversed s i = rv i. Proof. by rewrite ffunE. Qed.

Lemma table_glued : glued s.
Proof.
split=> i.
- by apply: val_inj; rewrite !twinE tw_tw.
- by rewrite -val_eqE twinE tw_neq.
- by apply: val_inj; rewrite !nextE; have [-> _ _ _] := entry_ok i.
- by rewrite -val_eqE nextE; have [_ -> _ _] := entry_ok i.
by rewrite !reversedE twinE; have [_ _ -> _] := entry_ok i.
Qed.

(* The darts of the cover as numbers. *)
Let cval (z : 'I_n.+1 * bool) := (val z.1, z.2).

Let cval_inj : injective cval.
Proof. by case=> i e [j e'] [/val_inj-> ->]. Qed.

Let cnextE' z : cval (cnext s z) = cnx (cval z).
Proof.
by case: z => i [] ; rewrite cnextE /cval /cnx /= ?(next_inv table_glued) ?nextE ?/prev ?nextE.
Qed.

Let csigmaE' z : cval (csigma s z) = cturn (cval z).
Proof.
rewrite csigmaE cnextE' ctwinE /cturn; congr (cnx (_, _)); first exact: twinE.
by rewrite reversedE.
Qed.

Let clabelE z : val (clabel s z) = clab (cval z).
Proof. by case: z => i []; rewrite /clabel /clab /= originE ?nextE. Qed.

Let aroundE z : cval (around s z) = caround (cval z).
Proof. by rewrite /around cnextE'. Qed.

Let csigma_iter k z : cval ((csigma s ^+ k)%g z) = iter k cturn (cval z).
Proof.
elim: k => [|k IHk]; first by rewrite expg0 perm1.
by rewrite expgSr permM csigmaE' IHk.
Qed.

Let cover_mem z : cval z \in cover.
Proof.
by case: z => i e; rewrite mem_cat; apply/orP; case: e; [right | left]; apply/mapP; exists (val i).
Qed.

Let orbit_mem k z w : cval w \in traject cturn (cval z) k -> w \in porbit (csigma s) z.
Proof.
by case/trajectP => l _ def_w; apply/porbitP; exists l; apply: cval_inj; rewrite csigma_iter.
Qed.

Lemma table_constant z : clabel s (csigma s z) = clabel s z.
Proof.
have [_ _ /allP/(_ _ (cover_mem z))/andP[/eqP same _] _ _] := and5P ok.
by apply: val_inj; rewrite !clabelE csigmaE' same.
Qed.

Theorem table_well_formed : signed_well_formed s.
Proof.
split; first exact: table_glued.
  move=> z w; apply/eqP/orP => [eq_zw|].
    have [_ _ /allP/(_ _ (cover_mem z))/andP[_ /allP/(_ _ (cover_mem w)) alike] _ _] := and5P ok.
    move: alike; rewrite -!clabelE eq_zw eqxx /= => /orP[/orbit_mem|]; first by left.
    by rewrite -aroundE => /orbit_mem; right.
  by case=> /(clabel_porbit table_constant)->; rewrite ?clabel_around.
move=> v; have [_ _ _ /allP/(_ (val v)) used _] := and5P ok.
move: used; rewrite mem_iota ltn_ord => /(_ isT) /hasP[k].
rewrite mem_iota => /andP[_ le_kn] /eqP def_v; exists (Ordinal le_kn).
by apply: val_inj; rewrite originE.
Qed.

Theorem table_loopless : loopless (base s).
Proof. by move=> i; rewrite -val_eqE !originE nextE; have [_ _ _ ->] := entry_ok i. Qed.

Theorem table_connected : connected (base s).
Proof.
move=> i j; have [_ _ _ _ /allP/(_ _ (dart i))/allP/(_ _ (dart j))] := and5P ok.
have: forall k, k \in [:: val i] -> exists2 x, val x = k & connect (link (base s)) i x.
  by move=> k; rewrite inE => /eqP->; exists i.
elim: rounds [:: val i] => [|r IHr] xs conn /=.
  by move/conn => [x /val_inj-> ].
apply: IHr => k; rewrite mem_undup !mem_cat => /or3P[/conn //| | ] /mapP[l /conn[x <- ix] ->].
  exists (twin (base s) x); first exact: twinE.
  by apply: connect_trans ix (connect1 _); rewrite /link eqxx.
exists (next (base s) x); first exact: nextE.
by apply: connect_trans ix (connect1 _); rewrite /link eqxx orbT.
Qed.

Fixpoint table_walk (w : seq bool) k :=
  if w is c :: w' then table_walk w' (if c then nx k else tw k) else k.
Fixpoint table_parity (w : seq bool) k :=
  if w is c :: w' then if c then table_parity w' (nx k) else rv k (+) table_parity w' (tw k)
  else false.

Theorem table_not_orientable w :
  (table_walk w 0 == 0) && table_parity w 0 -> ~ orientable s.
Proof.
have walkE u i : val (walk s u i) = table_walk u i.
  by elim: u i => //= c u IHu i; rewrite IHu; case: c; rewrite ?nextE ?twinE.
have parityE u i : parity s u i = table_parity u i.
  by elim: u i => //= c u IHu i; case: c; rewrite IHu ?nextE ?twinE ?reversedE.
case/andP=> /eqP back odd_w; apply: (@odd_way_not_orientable _ _ s w ord0).
  by apply: val_inj; rewrite walkE.
by rewrite parityE.
Qed.

Theorem table_class : 3 <= m -> signed_class s.
Proof.
move=> many; split; [exact: table_well_formed|exact: table_loopless|exact: table_connected|].
by apply: signed_three_neighbour table_well_formed table_connected _; rewrite card_ord.
Qed.

(* The flip of the edge of dart k is allowed. *)
Theorem table_allowed k : k <= n -> og (nx (nx k)) != og (nx (nx (tw k))) ->
  exists h, allowed (base s) h.
Proof.
move=> le_k differ; exists (Ordinal (le_k : k < n.+1)).
by rewrite /allowed /corner /prev -val_eqE !originE !nextE twinE.
Qed.

(* The Euler characteristic, from the number of darts. *)
Theorem table_euler e f : n.+1 = e * 2 -> n.+1 = f * 3 ->
  signed_euler s = (m.+1%:Z - e%:Z + f%:Z)%R.
Proof.
move=> n_e n_f; rewrite /signed_euler (signed_vertices_labels table_well_formed) card_ord.
have wf0 := named_base_well_formed table_glued.
have -> : edges (base s) = e.
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 2)) [edges _ * 2](edges2 wf0) card_ord n_e.
suff -> : faces (base s) = f by [].
by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) (signed_faces table_glued) card_ord n_f.
Qed.

End Table.

(* The projective plane with six vertices. *)
Definition projective_plane_table : seq (nat * nat * bool) :=
  [:: (2, 0, true); (6, 0, true); (4, 1, true); (20, 1, true); (0, 2, false); (10, 0, false);
      (8, 1, true); (24, 1, true); (1, 3, false); (14, 0, false); (12, 2, false); (28, 4, false);
      (5, 4, false); (18, 0, false); (16, 3, true); (21, 3, true); (9, 5, true); (13, 5, true);
      (17, 4, true); (23, 4, true); (22, 2, false); (29, 5, false); (3, 5, true); (27, 5, true);
      (26, 3, true); (11, 3, true); (7, 4, false); (19, 1, false); (25, 2, true); (15, 2, true)].

Lemma projective_plane_ok : signed_table_ok 29 5 projective_plane_table 12.
Proof. by vm_compute. Qed.
Definition projective_plane := table_signed projective_plane_ok.

Theorem projective_plane_not_orientable :
  [/\ signed_class projective_plane, signed_euler projective_plane = 1%R &
      forall s, signed_reach projective_plane s -> ~ orientable s].
Proof.
have wf := table_well_formed projective_plane_ok; split; first exact: table_class.
  by rewrite (table_euler projective_plane_ok (e := 15) (f := 10)).
move=> s r; apply: (signed_reach_not_orientable wf r).
pose way := [:: false; true; false; true; false; true; false; true; true; false; true].
by apply: (@table_not_orientable _ _ _ _ _ way); vm_compute.
Qed.

Theorem projective_plane_flip : exists h, allowed (base projective_plane) h.
Proof. by apply: (@table_allowed _ _ _ _ _ 0). Qed.

(* A Klein bottle with four vertices. *)
Definition klein_bottle_table : seq (nat * nat * bool) :=
  [:: (2, 0, false); (14, 2, false); (4, 2, false); (19, 3, false); (0, 3, false); (6, 0, false);
      (8, 3, false); (10, 1, false); (5, 1, true); (22, 1, true); (12, 3, false); (23, 2, false);
      (7, 2, false); (1, 1, false); (13, 0, true); (18, 0, true); (15, 2, false); (11, 0, false);
      (16, 1, false); (20, 2, false); (3, 1, false); (9, 3, false); (21, 0, false); (17, 3, false)].

Lemma klein_bottle_ok : signed_table_ok 23 3 klein_bottle_table 12.
Proof. by vm_compute. Qed.

Definition klein_bottle := table_signed klein_bottle_ok.

Theorem klein_bottle_not_orientable :
  [/\ signed_class klein_bottle, signed_euler klein_bottle = 0%R &
      forall s, signed_reach klein_bottle s -> ~ orientable s].
Proof.
have wf := table_well_formed klein_bottle_ok; split; first exact: table_class.
  by rewrite (table_euler klein_bottle_ok (e := 12) (f := 8)).
move=> s r; apply: (signed_reach_not_orientable wf r).
pose way := [:: false; true; false; true; false; true; true; false; true; true].
by apply: (@table_not_orientable _ _ _ _ _ way); vm_compute.
Qed.

Theorem klein_bottle_flip : exists h, allowed (base klein_bottle) h.
Proof. by apply: (@table_allowed _ _ _ _ _ 0). Qed.

(* Two surfaces that are not orientable, found to be what is said by calculation: the projective
   plane with six vertices, in which each two are joined by one edge ([projective_plane]), and a
   Klein bottle with four vertices ([klein_bottle]).  So Theorem 4.2 for signed surfaces does not
   speak of orientable ones only: in each of these some edge may be flipped, and what any flips
   lead to is not orientable ([signed_reach_not_orientable]). *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.
From Tightflip Require Import surface flip signed orientability numbered.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* The parity of the reversed sides that are crossed by a walk. *)
Section Walk.

Variables D V : finType.
Variable s : signed D V.

Fixpoint parity (w : seq bool) x :=
  if w is c :: w' then
    if c then parity w' (next (base s) x) else reversed s x (+) parity w' (twin (base s) x)
  else false.

(* A way round that crosses an odd number of reversed sides forbids every orientation. *)
Lemma odd_way_not_orientable w x : walk (base s) w x = x -> parity w x -> ~ orientable s.
Proof.
move=> back odd_w [o [o_next o_twin]].
have o_walk u y : o (walk (base s) u y) = o y (+) parity u y.
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

(* Surfaces from tables, which have next, origin and reversed of each dart.  The vertices are 0 to
   m. *)
Section Table.

Variables (n m : nat) (table : seq (nat * nat * bool)).

Let entry i := nth (0, 0, false) table i.
Let nx i := (entry i).1.1.
Let og i := (entry i).1.2.
Let rv i := (entry i).2.

(* The double cover: next, turning about the vertex, label, the other dart of the same corner. *)
Let cnx (z : nat * bool) := (if z.2 then nx (nx z.1) else nx z.1, z.2).
Let cturn (z : nat * bool) := cnx (mate z.1, z.2 (+) rv z.1).
Let clab (z : nat * bool) := og (if z.2 then nx z.1 else z.1).
Let caround (z : nat * bool) := cnx (z.1, ~~ z.2).

Let darts := iota 0 n.+1.
Let cover := [seq (k, false) | k <- darts] ++ [seq (k, true) | k <- darts].

(* Everything is in order, by calculation; all darts are reached in so many rounds. *)
Definition signed_table_ok rounds :=
  [&& numbered_ok n m nx og rounds,
      all (fun i => rv (mate i) == rv i) darts &
      all (fun z => let orbit := traject cturn z n in
                    let other := traject cturn (caround z) n in
                    (clab (cturn z) == clab z) &&
                    all (fun w => (clab z == clab w) ==> (w \in orbit) || (w \in other)) cover)
        cover].

Variable rounds : nat.
Hypothesis ok : signed_table_ok rounds.

Let in_order : numbered_ok n m nx og rounds. Proof. by case/and3P: ok. Qed.

Definition table_signed : signed [finType of 'I_n.+1] [finType of 'I_m.+1] :=
  Signed (numbered in_order) [ffun i : 'I_n.+1 => rv i].

Let s := table_signed.

Let twinE i : val (twin (base s) i) = mate i. Proof. exact: numbered_twin. Qed.
Let nextE i : val (next (base s) i) = nx i. Proof. exact: numbered_next. Qed.
Let originE i : val (origin (base s) i) = og i. Proof. exact: numbered_origin. Qed.
Let reversedE i : reversed s i = rv i. Proof. by rewrite ffunE. Qed.

Lemma table_glued : glued s.
Proof.
split; [exact: numbered_twinK | exact: numbered_twin_neq | exact: numbered_next3 |
  exact: numbered_next_neq |].
have [_ /allP same _] := and3P ok => i.
by rewrite !reversedE twinE (eqP (same _ (dart_number i))).
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
case: z => i e; rewrite mem_cat; apply/orP; case: e; [right | left]; apply/mapP;
  by exists (val i); rewrite // dart_number.
Qed.

Let orbit_mem k z w : cval w \in traject cturn (cval z) k -> w \in porbit (csigma s) z.
Proof.
by case/trajectP => l _ def_w; apply/porbitP; exists l; apply: cval_inj; rewrite csigma_iter.
Qed.

Lemma table_constant z : clabel s (csigma s z) = clabel s z.
Proof.
have [_ _ /allP/(_ _ (cover_mem z))/andP[/eqP same _]] := and3P ok.
by apply: val_inj; rewrite !clabelE csigmaE' same.
Qed.

Theorem table_well_formed : signed_well_formed s.
Proof.
split; [exact: table_glued | move=> z w | exact: numbered_used].
apply/eqP/orP => [eq_zw|].
  have [_ _ /allP/(_ _ (cover_mem z))/andP[_ /allP/(_ _ (cover_mem w)) alike]] := and3P ok.
  move: alike; rewrite -!clabelE eq_zw eqxx /= => /orP[/orbit_mem|]; first by left.
  by rewrite -aroundE => /orbit_mem; right.
by case=> /(clabel_porbit table_constant)->; rewrite ?clabel_around.
Qed.

Fixpoint table_parity (w : seq bool) k :=
  if w is c :: w' then if c then table_parity w' (nx k) else rv k (+) table_parity w' (mate k)
  else false.

Theorem table_not_orientable w :
  (walk_numbers nx w 0 == 0) && table_parity w 0 -> ~ orientable s.
Proof.
have parityE u i : parity s u i = table_parity u i.
  by elim: u i => //= c u IHu i; case: c; rewrite IHu ?nextE ?twinE ?reversedE.
case/andP=> /eqP back odd_w; apply: (@odd_way_not_orientable _ _ s w ord0).
  by apply: val_inj; rewrite [LHS]numbered_walk.
by rewrite parityE.
Qed.

Theorem table_class : 3 <= m -> signed_class s.
Proof.
move=> many; split; [exact: table_well_formed|exact: numbered_loopless|exact: numbered_connected|].
by apply: signed_three_neighbour table_well_formed (numbered_connected _) _; rewrite card_ord.
Qed.

(* The flip of the edge of dart k is allowed. *)
Theorem table_allowed k : k <= n -> og (nx (nx k)) != og (nx (nx (mate k))) ->
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

(* What is claimed of a table in which a way round crosses an odd number of reversed sides. *)
Lemma table_never_orientable w e f : 3 <= m -> n.+1 = e * 2 -> n.+1 = f * 3 ->
  (walk_numbers nx w 0 == 0) && table_parity w 0 ->
  [/\ signed_class s, signed_euler s = (m.+1%:Z - e%:Z + f%:Z)%R &
      forall s', signed_reach s s' -> ~ orientable s'].
Proof.
move=> many n_e n_f odd_w; split; [exact: table_class | exact: table_euler|].
move=> s' r; apply: signed_reach_not_orientable table_well_formed r _.
exact: table_not_orientable odd_w.
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
pose way := [:: false; true; false; true; false; true; false; true; true; false; true].
by apply: (table_never_orientable projective_plane_ok (w := way) (e := 15) (f := 10)); vm_compute.
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
pose way := [:: false; true; false; true; false; true; true; false; true; true].
by apply: (table_never_orientable klein_bottle_ok (w := way) (e := 12) (f := 8)); vm_compute.
Qed.

Theorem klein_bottle_flip : exists h, allowed (base klein_bottle) h.
Proof. by apply: (@table_allowed _ _ _ _ _ 0). Qed.

(* Two flips hang a part of the walk's graph elsewhere.

   Where x and y follow one another as neighbours of u on the walk round the hub a, two flips make
   y, with all that hangs at it, a neighbour of x instead of u, on that side of x: [hang_back] where
   x comes before y, [hang_on] where y comes before x. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach hub book patch sorting contour.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Two entries of a list are changed. *)
Definition change (T : eqType) (e1 e1' e2 e2' e : T) :=
  if e == e1 then e1' else if e == e2 then e2' else e.

Lemma path_change (T : eqType) (step step' : rel T) (gs gt : T -> T) (o e : T) l z :
    (forall e f, step e f -> e != o -> step' (gs e) (gt f)) ->
    o \notin e :: l -> {in l, gs =1 id} -> {in l, gt =1 id} ->
  path step e (rcons l z) -> path step' (gs e) (rcons l (gt z)).
Proof.
move=> steps; elim: l e => [|i l IHl] e /=.
  by rewrite inE !andbT eq_sym => oe _ _ ef; apply: steps.
rewrite !inE !negb_or => /and3P[oe oi ol] fix_s fix_t /andP[ei pl].
have is_i : gt i = i by apply: fix_t; rewrite mem_head.
have is_i' : gs i = i by apply: fix_s; rewrite mem_head.
rewrite -{1}is_i steps // 1?eq_sym //=; rewrite -{1}is_i'; apply: IHl => //.
- by rewrite inE negb_or oi.
- by move=> j jl; apply: fix_s; rewrite inE jl orbT.
by move=> j jl; apply: fix_t; rewrite inE jl orbT.
Qed.

(* The three faces as tables.  The labels 0, 1, 2, 3 are a, u, x, y.  [back]: the darts
   0 ua  1 ax  2 xu   3 au  4 uy  5 ya   6 yu  7 ua  8 ay; [on]: the darts
   0 ua  1 ay  2 yu   3 au  4 ux  5 xa   6 uy  7 ya  8 au. *)
Definition back_twin := [:: 3; 9; 9; 0; 6; 9; 4; 9; 9].
Definition back_table : table :=
  ([:: 1; 2; 0; 4; 5; 3; 7; 8; 6], [:: 1; 0; 2; 0; 1; 3; 3; 1; 0]).
Definition back_after : table :=
  ([:: 6; 3; 7; 5; 2; 1; 8; 4; 0], [:: 3; 0; 2; 2; 0; 3; 2; 1; 0]).
Definition on_twin := [:: 3; 9; 6; 0; 9; 9; 2; 9; 9].
Definition on_table : table :=
  ([:: 1; 2; 0; 4; 5; 3; 7; 8; 6], [:: 1; 0; 3; 0; 1; 2; 1; 3; 0]).
Definition on_after : table :=
  ([:: 7; 3; 0; 5; 6; 1; 8; 2; 4], [:: 2; 0; 0; 3; 1; 2; 2; 3; 0]).

Lemma back_afterE : run 9 back_twin [:: 0; 4] back_table = back_after.
Proof. by vm_compute. Qed.
Lemma on_afterE : run 9 on_twin [:: 0; 2] on_table = on_after.
Proof. by vm_compute. Qed.

(* Four labels that differ. *)
Lemma label_neqs (T : eqType) (a u x y : T) : uniq [:: a; u; x; y] ->
  (((a == u) = false) * ((a == x) = false) * ((a == y) = false) * ((u == x) = false) *
   ((u == y) = false) * ((x == y) = false) * ((u == a) = false) * ((x == a) = false) *
   ((y == a) = false) * ((x == u) = false) * ((y == u) = false) * ((y == x) = false))%type.
Proof.
rewrite /= !inE !negb_or -!andbA andbT; case/and5P=> n1 n2 n3 n4 /andP[n5 n6].
by do !split; apply/negbTE => //; rewrite eq_sym.
Qed.

Section Hang.

Variables D V : finType.
Variables (s : surface D V) (a : V) (c : seq (V * V)).
Hypothesis gd : good s.
Hypothesis hub_a : hub s a.
Hypothesis con : contour s a c.
Variables u x y : V.
Hypothesis xy : x != y.

Let wf := good_wf gd.
Let lf := good_loopless gd.
Let corners_inj := contour_corners_inj wf hub_a con.

Let ends_a d : corner s d = a -> [/\ origin s d != origin s (next s d), origin s d != a &
  origin s (next s d) != a].
Proof.
by move=> cd; have [n1 n2 n3] := corners_differ wf lf d; rewrite -cd n1 n2 eq_sym n3.
Qed.

Definition hang_label := nth a [:: a; u; x; y].

Lemma hang_label_inj : uniq [:: a; u; x; y] ->
  forall i j, i < 4 -> j < 4 -> hang_label i = hang_label j -> i = j.
Proof.
move=> un i j lt_i lt_j eq_l; apply/eqP; rewrite -(nth_uniq a _ _ un) //; exact/eqP.
Qed.

Section Back.

Variable d0 : D.
Hypothesis nd0 : origin s (next s d0) = a.
Hypothesis e_x : (corner s d0, origin s d0) = (x, u).
Hypothesis e_y : corner s (twin s d0) = y.

Let t := twin s d0.
Let z := twin s (next s t).
Definition back_dart := nth d0 [:: d0; next s d0; prev s d0; t; next s t; prev s t;
                                   z; next s z; prev s z].

Let c0 : corners s d0 = (u, a, x). Proof. by move: e_x => [<- <-]; rewrite /corners nd0. Qed.
Let ct : corners s t = (a, u, y).
Proof. by rewrite corners_twin // -/t e_y nd0; move: e_x => [_ <-]. Qed.
Let cz : corners s z = (y, u, a).
Proof.
have [o n k] := ct; have cnt : corner s (next s t) = a by rewrite /corner /prev (next3 wf).
by rewrite corners_twin // (corner_opposite wf lf hub_a cnt) -/(prev s t) n -/(corner s t) k.
Qed.

Lemma back_labels : uniq [:: a; u; x; y].
Proof.
have [o n k] := c0; have [o' n' k'] := ct.
have [n1 n2 n3] := corners_differ wf lf d0; have [m1 m2 m3] := corners_differ wf lf t.
rewrite o n k in n1 n2 n3; rewrite o' n' k' in m1 m2 m3.
by rewrite /= !inE !negb_or xy m1 n2 eq_sym m3 eq_sym n3 m2.
Qed.

Lemma patch_back : patch 9 back_twin back_dart hang_label s back_table.
Proof.
have [e1 e2 e3] := c0; have [f1 f2 f3] := ct; have [g1 g2 g3] := cz.
have tK := twinK wf; have pK := prevK wf.
by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; split=> [||_] //=; rewrite ?pK ?tK.
Qed.

Let dart_inj i j : i < 9 -> j < 9 -> back_dart i = back_dart j -> i = j.
Proof. exact: (patch_inj (T := back_table) (hang_label_inj back_labels) _ _ _ _ patch_back). Qed.

Lemma back_at : exists s', [/\ reach_in s 2 s', good s', hub s' a,
  forall e f, link_step s a e f -> e != (x, u) ->
    link_step s' a (change (u, y) (x, y) (y, u) (x, u) e) (change (x, u) (x, y) (y, u) (y, x) f) &
  link_step s' a (y, x) (x, u)].
Proof.
have par := patch_back; have ok : table_ok 9 back_table by [].
have ok' : table_ok 9 back_after by [].
have un := back_labels; have l_inj := hang_label_inj un.
have [//|s' [r gd' par' tw' out']] := patch_run l_inj dart_inj (p := [:: 0; 4]) gd _ par.
rewrite back_afterE in par'.
have out_corners w : outside 9 back_dart w -> corners s' w = corners s w.
  move=> ow; have ow1 := patch_outside_next wf ok par ow.
  have ow2 := patch_outside_next wf ok par ow1.
  have [n0 o0] := out' w ow; have [n1 o1] := out' _ ow1; have [n2 o2] := out' _ ow2.
  by rewrite /corners /corner /prev n0 n1 o0 o1 o2.
have old i : i < 9 -> corners s (back_dart i) = (hang_label (tlabel back_table i),
    hang_label (tlabel back_table (tnext back_table i)), hang_label (tcorner back_table i)).
  by move=> lt_i; apply: patch_corners ok par lt_i.
have new i : i < 9 -> corners s' (back_dart i) = (hang_label (tlabel back_after i),
    hang_label (tlabel back_after (tnext back_after i)), hang_label (tcorner back_after i)).
  by move=> lt_i; apply: patch_corners ok' par' lt_i.
have hub' : hub s' a.
  move=> w; case: (outsideP 9 back_dart w) => [[i lt_i ->] | ow]; rewrite /at_face.
    have [-> -> ->] := new i lt_i; move: i lt_i.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /= !eqxx ?orbT.
  by have [-> -> ->] := out_corners w ow; apply: hub_a.
have not_in w i : outside 9 back_dart w -> i < 9 -> corners s w != corners s (back_dart i).
  by move=> ow lt_i; apply: contra (ow i lt_i) => /eqP /corners_inj->.
have E := label_neqs un.
have to_hub d : origin s (next s d) = a -> d != d0 -> origin s' (next s' d) = a /\
    (corner s' d, origin s' d) = change (u, y) (x, y) (y, u) (x, u) (corner s d, origin s d).
  move=> nd d_d0; case: (outsideP 9 back_dart d) => [[i lt_i def_d] | od].
    have cd := old i lt_i; have cd' := new i lt_i; move/eqP: nd d_d0; rewrite def_d.
    case: cd => -> -> ->; case: cd' => -> -> ->; move: i lt_i {def_d}.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
      rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners d od; split=> //; rewrite /change.
  have := not_in d 5 od isT; have := not_in d 7 od isT; rewrite !old //.
  rewrite /tcorner /tlabel /tnext /hang_label /= /corners nd !xpair_eqE eqxx /= !andbT.
  by rewrite andbC => /negbTE-> ; rewrite andbC => /negbTE->.
have from_hub w : origin s w = a -> w != t -> origin s' w = a /\
    (origin s' (next s' w), corner s' w) =
      change (x, u) (x, y) (y, u) (y, x) (origin s (next s w), corner s w).
  move=> ow_a w_t; case: (outsideP 9 back_dart w) => [[i lt_i def_w] | ow].
    have cw := old i lt_i; have cw' := new i lt_i; move/eqP: ow_a w_t; rewrite def_w.
    case: cw => -> -> ->; case: cw' => -> -> ->; move: i lt_i {def_w}.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
      rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners w ow; split=> //; rewrite /change.
  have := not_in w 1 ow isT; have := not_in w 8 ow isT; rewrite !old //.
  rewrite /tcorner /tlabel /tnext /hang_label /= /corners ow_a !xpair_eqE eqxx /=.
  by move=> /negbTE n8 /negbTE n1; rewrite n1 n8.
have wf' := good_wf gd'.
exists s'; split=> // [e f|].
  case/existsP => d /and3P[/eqP nd /eqP def_e /eqP def_f] e_X.
  have d_d0 : d != d0 by apply: contra e_X => /eqP dd; rewrite def_e dd e_x.
  have [nd' ends_d] := to_hub d nd d_d0.
  have [ot' ends_t] : origin s' (twin s d) = a /\ (origin s' (next s' (twin s d)),
      corner s' (twin s d)) = change (x, u) (x, y) (y, u) (y, x) f.
    rewrite def_f -(origin_next_twin wf d); apply: from_hub; first by rewrite (origin_twin wf).
    by rewrite (inj_eq (@twin_inj _ _ s)).
  apply/existsP; exists d; rewrite nd' eqxx /= {1}def_e ends_d eqxx /= -ends_t.
  by rewrite -(origin_next_twin wf' d) tw'.
have [c6 n6 k6] := new 6 isT; have [c4 n4 k4] := new 4 isT.
have [_ _ /(_ isT) t6] := par' 6 isT.
apply/existsP; exists (back_dart 6).
by rewrite c6 n6 k6 t6 k4 /= !eqxx.
Qed.

End Back.

Section On.

Variable d0 : D.
Hypothesis nd0 : origin s (next s d0) = a.
Hypothesis e_y : (corner s d0, origin s d0) = (y, u).
Hypothesis e_x : corner s (twin s d0) = x.

Let t := twin s d0.
Let z := twin s (prev s d0).
Definition on_dart := nth d0 [:: d0; next s d0; prev s d0; t; next s t; prev s t;
                                   z; next s z; prev s z].

Let c0 : corners s d0 = (u, a, y). Proof. by move: e_y => [<- <-]; rewrite /corners nd0. Qed.
Let ct : corners s t = (a, u, x).
Proof. by rewrite corners_twin // -/t e_x nd0; move: e_y => [_ <-]. Qed.
Let cz : corners s z = (u, y, a).
Proof.
have [o n k] := c0; have cp : corner s (prev s d0) = a by rewrite /corner /prev (next3 wf).
rewrite corners_twin // (corner_opposite wf lf hub_a cp) prevK // o.
by rewrite -/(corner s d0) k.
Qed.

Lemma on_labels : uniq [:: a; u; x; y].
Proof.
have [o n k] := c0; have [o' n' k'] := ct.
have [n1 n2 n3] := corners_differ wf lf d0; have [m1 m2 m3] := corners_differ wf lf t.
rewrite o n k in n1 n2 n3; rewrite o' n' k' in m1 m2 m3.
by rewrite /= !inE !negb_or xy m1 n2 m2 [a == x]eq_sym m3 [u == y]eq_sym n3.
Qed.

Lemma patch_on : patch 9 on_twin on_dart hang_label s on_table.
Proof.
have [e1 e2 e3] := c0; have [f1 f2 f3] := ct; have [g1 g2 g3] := cz.
have tK := twinK wf; have pK := prevK wf.
by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; split=> [||_] //=; rewrite ?pK ?tK.
Qed.

Let dart_inj i j : i < 9 -> j < 9 -> on_dart i = on_dart j -> i = j.
Proof. exact: (patch_inj (T := on_table) (hang_label_inj on_labels) _ _ _ _ patch_on). Qed.

Lemma on_at : exists s', [/\ reach_in s 2 s', good s', hub s' a,
  forall e f, link_step s a e f -> e != (y, u) ->
    link_step s' a (change (u, x) (y, x) (u, y) (x, y) e) (change (y, u) (y, x) (u, y) (u, x) f) &
  link_step s' a (u, x) (x, y)].
Proof.
have par := patch_on; have ok : table_ok 9 on_table by [].
have ok' : table_ok 9 on_after by [].
have un := on_labels; have l_inj := hang_label_inj un.
have [//|s' [r gd' par' tw' out']] := patch_run l_inj dart_inj (p := [:: 0; 2]) gd _ par.
rewrite on_afterE in par'.
have out_corners w : outside 9 on_dart w -> corners s' w = corners s w.
  move=> ow; have ow1 := patch_outside_next wf ok par ow.
  have ow2 := patch_outside_next wf ok par ow1.
  have [n0 o0] := out' w ow; have [n1 o1] := out' _ ow1; have [n2 o2] := out' _ ow2.
  by rewrite /corners /corner /prev n0 n1 o0 o1 o2.
have old i : i < 9 -> corners s (on_dart i) = (hang_label (tlabel on_table i),
    hang_label (tlabel on_table (tnext on_table i)), hang_label (tcorner on_table i)).
  by move=> lt_i; apply: patch_corners ok par lt_i.
have new i : i < 9 -> corners s' (on_dart i) = (hang_label (tlabel on_after i),
    hang_label (tlabel on_after (tnext on_after i)), hang_label (tcorner on_after i)).
  by move=> lt_i; apply: patch_corners ok' par' lt_i.
have hub' : hub s' a.
  move=> w; case: (outsideP 9 on_dart w) => [[i lt_i ->] | ow]; rewrite /at_face.
    have [-> -> ->] := new i lt_i; move: i lt_i.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /= !eqxx ?orbT.
  by have [-> -> ->] := out_corners w ow; apply: hub_a.
have not_in w i : outside 9 on_dart w -> i < 9 -> corners s w != corners s (on_dart i).
  by move=> ow lt_i; apply: contra (ow i lt_i) => /eqP /corners_inj->.
have E := label_neqs un.
have to_hub d : origin s (next s d) = a -> d != d0 -> origin s' (next s' d) = a /\
    (corner s' d, origin s' d) = change (u, x) (y, x) (u, y) (x, y) (corner s d, origin s d).
  move=> nd d_d0; case: (outsideP 9 on_dart d) => [[i lt_i def_d] | od].
    have cd := old i lt_i; have cd' := new i lt_i; move/eqP: nd d_d0; rewrite def_d.
    case: cd => -> -> ->; case: cd' => -> -> ->; move: i lt_i {def_d}.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
      rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners d od; split=> //; rewrite /change.
  have := not_in d 5 od isT; have := not_in d 7 od isT; rewrite !old //.
  rewrite /tcorner /tlabel /tnext /hang_label /= /corners nd !xpair_eqE eqxx /= !andbT.
  by rewrite andbC => /negbTE-> ; rewrite andbC => /negbTE->.
have from_hub w : origin s w = a -> w != t -> origin s' w = a /\
    (origin s' (next s' w), corner s' w) =
      change (y, u) (y, x) (u, y) (u, x) (origin s (next s w), corner s w).
  move=> ow_a w_t; case: (outsideP 9 on_dart w) => [[i lt_i def_w] | ow].
    have cw := old i lt_i; have cw' := new i lt_i; move/eqP: ow_a w_t; rewrite def_w.
    case: cw => -> -> ->; case: cw' => -> -> ->; move: i lt_i {def_w}.
    by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
      rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners w ow; split=> //; rewrite /change.
  have := not_in w 1 ow isT; have := not_in w 8 ow isT; rewrite !old //.
  rewrite /tcorner /tlabel /tnext /hang_label /= /corners ow_a !xpair_eqE eqxx /=.
  by move=> /negbTE n8 /negbTE n1; rewrite n1 n8.
have wf' := good_wf gd'.
exists s'; split=> // [e f|].
  case/existsP => d /and3P[/eqP nd /eqP def_e /eqP def_f] e_X.
  have d_d0 : d != d0 by apply: contra e_X => /eqP dd; rewrite def_e dd e_y.
  have [nd' ends_d] := to_hub d nd d_d0.
  have [ot' ends_t] : origin s' (twin s d) = a /\ (origin s' (next s' (twin s d)),
      corner s' (twin s d)) = change (y, u) (y, x) (u, y) (u, x) f.
    rewrite def_f -(origin_next_twin wf d); apply: from_hub; first by rewrite (origin_twin wf).
    by rewrite (inj_eq (@twin_inj _ _ s)).
  apply/existsP; exists d; rewrite nd' eqxx /= {1}def_e ends_d eqxx /= -ends_t.
  by rewrite -(origin_next_twin wf' d) tw'.
have [c6 n6 k6] := new 6 isT; have [c2 n2 k2] := new 2 isT.
have [_ _ /(_ isT) t6] := par' 6 isT.
apply/existsP; exists (on_dart 6).
by rewrite c6 n6 k6 t6 k2 /= !eqxx.
Qed.

End On.

End Hang.

(* Each face has one side opposite to the hub. *)
Lemma card_opposite (D V : finType) (s : surface D V) a :
  good s -> hub s a -> #|opposite s a| = faces s.
Proof.
move=> gd hub_a; rewrite -((hubP a gd).1 hub_a) /degree.
have -> : opposite s a = prev s @^-1: [set x | origin s x == a].
  by apply/setP => x; rewrite !inE.
by apply: on_card_preimset; exists (next s) => x _; [apply: prevK | apply: nextK]; case: gd.
Qed.

Lemma faces_darts (D V : finType) (s s' : surface D V) :
  well_formed s -> well_formed s' -> faces s = faces s'.
Proof. by move=> wf wf'; apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) !faces3. Qed.

Section Words.

Lemma three_apart (T : eqType) (e1 e2 e3 : T) w l :
    uniq w -> perm_eq w (e1 :: e2 :: e3 :: l) ->
  [/\ e1 != e2, e1 != e3, e2 != e3 & forall i, i \in l -> [/\ i != e1, i != e2 & i != e3]].
Proof.
move=> un /perm_uniq eq_un; move: un; rewrite {}eq_un /= !inE !negb_or.
case/and4P=> /and3P[n12 n13 o1] /andP[n23 o2] o3 _; split=> // i il.
by split; [apply: contraNneq o1 | apply: contraNneq o2 | apply: contraNneq o3] => <-.
Qed.

Lemma change_out (T : eqType) (e1 e1' e2 e2' e : T) :
  e != e1 -> e != e2 -> change e1 e1' e2 e2' e = e.
Proof. by rewrite /change => /negbTE-> /negbTE->. Qed.

Variables D V : finType.
Implicit Types (s : surface D V) (c r : seq (V * V)) (a u x y : V).

(* x comes before y: y is hung at x, behind what hangs there. *)
Theorem hang_back s a c r u x y : good s -> hub s a -> x != y ->
    contour s a ((x, u) :: (u, y) :: c ++ (y, u) :: r) ->
    uniq ((x, y) :: c ++ (y, x) :: (x, u) :: r) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a ((x, y) :: c ++ (y, x) :: (x, u) :: r)].
Proof.
move=> gd hub_a xy con un'; have [un cyc sz] := con.
have := cyc; rewrite /= => /andP[/existsP[d /and3P[/eqP nd /eqP[cd od] /eqP[_ ct]]] walk].
have un_l := back_labels gd xy nd (congr2 pair (esym cd) (esym od)) (esym ct).
have E := label_neqs un_l.
have [s' [r2 gd' hub' steps new]] :=
  back_at gd hub_a con xy nd (congr2 pair (esym cd) (esym od)) (esym ct).
have s_y : change (u, y) (x, y) (y, u) (x, u) (u, y) = (x, y) by rewrite /change eqxx.
have s_z : change (u, y) (x, y) (y, u) (x, u) (y, u) = (x, u).
  by rewrite /change !xpair_eqE !E !eqxx.
have t_x : change (x, u) (x, y) (y, u) (y, x) (x, u) = (x, y) by rewrite /change eqxx.
have t_z : change (x, u) (x, y) (y, u) (y, x) (y, u) = (y, x).
  by rewrite /change !xpair_eqE !E !eqxx.
exists s'; split=> //; split=> //; last first.
  rewrite (card_opposite gd' hub') -(faces_darts (good_wf gd) (good_wf gd')).
  by rewrite -(card_opposite gd hub_a) -sz /= !size_cat /= !addnS.
have perm_w : perm_eq ((x, u) :: (u, y) :: c ++ (y, u) :: r)
    ((x, u) :: (u, y) :: (y, u) :: c ++ r).
  by rewrite !perm_cons (perm_catCA c [:: (y, u)]).
have [n12 n13 n23 away] := three_apart un perm_w.
have awc i : i \in c -> [/\ i != (x, u), i != (u, y) & i != (y, u)].
  by move=> ic; apply: away; rewrite mem_cat ic.
have awr i : i \in r -> [/\ i != (x, u), i != (u, y) & i != (y, u)].
  by move=> ir; apply: away; rewrite mem_cat ir orbT.
move: walk; rewrite rcons_cat /= -cat_rcons cat_path last_rcons => /andP[walk1 walk2].
rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons /= new /=; apply/andP; split.
  have := path_change (o := (x, u)) (z := (y, u)) steps _ _ _ walk1; rewrite s_y t_z; apply.
  - by rewrite inE negb_or n12; apply/negP => /awc[/eqP].
  - by move=> i /awc[n1 n2 n3]; apply: change_out.
  by move=> i /awc[n1 n2 n3]; apply: change_out.
have := path_change (o := (x, u)) (z := (x, u)) steps _ _ _ walk2; rewrite s_z t_x; apply.
- by rewrite inE negb_or n13; apply/negP => /awr[/eqP].
- by move=> i /awr[n1 n2 n3]; apply: change_out.
by move=> i /awr[n1 n2 n3]; apply: change_out.
Qed.

(* y comes before x: y is hung at x, in front of what hangs there. *)
Theorem hang_on s a c r u x y : good s -> hub s a -> x != y ->
    contour s a ((u, y) :: c ++ (y, u) :: (u, x) :: r) ->
    uniq ((u, x) :: (x, y) :: c ++ (y, x) :: r) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a ((u, x) :: (x, y) :: c ++ (y, x) :: r)].
Proof.
move=> gd hub_a xy con un'; have [un cyc sz] := con.
have := cyc; rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons /= => /and3P[walk1].
case/existsP => d /and3P[/eqP nd /eqP[cd od] /eqP[_ ct]] walk2.
have un_l := on_labels gd xy nd (congr2 pair (esym cd) (esym od)) (esym ct).
have E := label_neqs un_l.
have [s' [r2 gd' hub' steps new]] :=
  on_at gd hub_a con xy nd (congr2 pair (esym cd) (esym od)) (esym ct).
have s_x : change (u, x) (y, x) (u, y) (x, y) (u, x) = (y, x) by rewrite /change eqxx.
have s_y : change (u, x) (y, x) (u, y) (x, y) (u, y) = (x, y).
  by rewrite /change !xpair_eqE !E !eqxx.
have t_z : change (y, u) (y, x) (u, y) (u, x) (y, u) = (y, x) by rewrite /change eqxx.
have t_y : change (y, u) (y, x) (u, y) (u, x) (u, y) = (u, x).
  by rewrite /change !xpair_eqE !E !eqxx.
exists s'; split=> //; split=> //; last first.
  rewrite (card_opposite gd' hub') -(faces_darts (good_wf gd) (good_wf gd')).
  by rewrite -(card_opposite gd hub_a) -sz /= !size_cat /= !addnS.
have perm_w : perm_eq ((u, y) :: c ++ (y, u) :: (u, x) :: r)
    ((y, u) :: (u, y) :: (u, x) :: c ++ r).
  apply/seq.permP => p; rewrite /= !count_cat /= (addnCA (count p c)) (addnCA (p (u, y))).
  by rewrite (addnCA (count p c)).
have [n12 n13 n23 away] := three_apart un perm_w.
have awc i : i \in c -> [/\ i != (y, u), i != (u, y) & i != (u, x)].
  by move=> ic; apply: away; rewrite mem_cat ic.
have awr i : i \in r -> [/\ i != (y, u), i != (u, y) & i != (u, x)].
  by move=> ir; apply: away; rewrite mem_cat ir orbT.
rewrite /= new /= rcons_cat /= -cat_rcons cat_path last_rcons; apply/andP; split.
  have := path_change (o := (y, u)) (z := (y, u)) steps _ _ _ walk1; rewrite s_y t_z; apply.
  - by rewrite inE negb_or n12; apply/negP => /awc[/eqP].
  - by move=> i /awc[n1 n2 n3]; apply: change_out.
  by move=> i /awc[n1 n2 n3]; apply: change_out.
have := path_change (o := (y, u)) (z := (u, y)) steps _ _ _ walk2; rewrite s_x t_y; apply.
- by rewrite inE negb_or n13; apply/negP => /awr[/eqP].
- by move=> i /awr[n1 n2 n3]; apply: change_out.
by move=> i /awr[n1 n2 n3]; apply: change_out.
Qed.

End Words.

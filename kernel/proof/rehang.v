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

(* On the walk the edge from p to u is followed by the one from u to q.  The two flips make one edge
   of the two, from p to q, and two of a third one, at the other end of what is hung elsewhere:
   the edge that leads to u from what hangs at q ([on] is false: it is hung at p), or the one that
   leaves u for what hangs at p ([on] is true: it is hung at q).  What came before the third edge
   is then followed by [third_in], and what came after it follows [third_out]. *)
Section Sides.

Variables (V : eqType) (on : bool) (u p q : V).

Definition third : V * V := if on then (u, p) else (q, u).
Definition third_in : V * V := if on then (u, q) else (q, p).
Definition third_out : V * V := if on then (q, p) else (p, u).

End Sides.

(* The three faces as tables.  The labels 0, 1, 2, 3 are a, u, p, q; the darts are
   0 ua  1 ap  2 pu   3 au  4 uq  5 qa, then 6 up  7 pa  8 au where [on] is true, and
   6 qu  7 ua  8 aq where it is false. *)
Definition hang_flips (on : bool) := [:: 0; if on then 2 else 4].
Definition hang_twin (on : bool) :=
  if on then [:: 3; 9; 6; 0; 9; 9; 2; 9; 9] else [:: 3; 9; 9; 0; 6; 9; 4; 9; 9].
Definition hang_table (on : bool) : table :=
  ([:: 1; 2; 0; 4; 5; 3; 7; 8; 6],
   [:: 1; 0; 2; 0; 1; 3] ++ if on then [:: 1; 2; 0] else [:: 3; 1; 0]).
Definition hang_after (on : bool) : table :=
  if on then ([:: 7; 3; 0; 5; 6; 1; 8; 2; 4], [:: 3; 0; 0; 2; 1; 3; 3; 2; 0])
  else ([:: 6; 3; 7; 5; 2; 1; 8; 4; 0], [:: 3; 0; 2; 2; 0; 3; 2; 1; 0]).

Lemma hang_afterE on : run 9 (hang_twin on) (hang_flips on) (hang_table on) = hang_after on.
Proof. by case: on; vm_compute. Qed.

(* Four labels that differ. *)
Lemma label_neqs (T : eqType) (a u p q : T) : uniq [:: a; u; p; q] ->
  (((a == u) = false) * ((a == p) = false) * ((a == q) = false) * ((u == p) = false) *
   ((u == q) = false) * ((p == q) = false) * ((u == a) = false) * ((p == a) = false) *
   ((q == a) = false) * ((p == u) = false) * ((q == u) = false) * ((q == p) = false))%type.
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
Variables (on : bool) (u p q : V) (d0 : D).
Hypothesis pq : p != q.
Hypothesis nd0 : origin s (next s d0) = a.
Hypothesis e_p : (corner s d0, origin s d0) = (p, u).
Hypothesis e_q : corner s (twin s d0) = q.

Let wf := good_wf gd.
Let lf := good_loopless gd.
Let corners_inj := contour_corners_inj wf hub_a con.

Let t := twin s d0.
Let z := twin s (if on then prev s d0 else next s t).
Definition hang_label := nth a [:: a; u; p; q].
Definition hang_dart := nth d0 [:: d0; next s d0; prev s d0; t; next s t; prev s t;
                                   z; next s z; prev s z].

Let c0 : corners s d0 = (u, a, p). Proof. by move: e_p => [<- <-]; rewrite /corners nd0. Qed.
Let ct : corners s t = (a, u, q).
Proof. by rewrite corners_twin // -/t e_q nd0; move: e_p => [_ <-]. Qed.
Let cz : corners s z = if on then (u, p, a) else (q, u, a).
Proof.
have [o n k] := c0; have [ot nt kt] := ct; rewrite /z; case: {+}on.
  have cp : corner s (prev s d0) = a by rewrite /corner /prev (next3 wf).
  by rewrite corners_twin // (corner_opposite wf lf hub_a cp) prevK // o -/(corner s d0) k.
have cn : corner s (next s t) = a by rewrite /corner /prev (next3 wf).
by rewrite corners_twin // (corner_opposite wf lf hub_a cn) -/(prev s t) nt -/(corner s t) kt.
Qed.

Lemma hang_labels : uniq [:: a; u; p; q].
Proof.
have [o n k] := c0; have [o' n' k'] := ct.
have [n1 n2 n3] := corners_differ wf lf d0; have [m1 m2 m3] := corners_differ wf lf t.
rewrite o n k in n1 n2 n3; rewrite o' n' k' in m1 m2 m3.
by rewrite /= !inE !negb_or pq m1 n2 eq_sym m3 eq_sym n3 m2.
Qed.

Lemma hang_label_inj i j : i < 4 -> j < 4 -> hang_label i = hang_label j -> i = j.
Proof.
move=> lt_i lt_j eq_l; apply/eqP; rewrite -(nth_uniq a _ _ hang_labels) //; exact/eqP.
Qed.

Lemma hang_patch : patch 9 (hang_twin on) hang_dart hang_label s (hang_table on).
Proof.
have [e1 e2 e3] := c0; have [f1 f2 f3] := ct; have := cz; rewrite /hang_dart /z.
have tK := twinK wf; have pK := prevK wf; case: {+}on => -[g1 g2 g3];
  by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; split=> [||_] //=; rewrite ?pK ?tK.
Qed.

Let ok : table_ok 9 (hang_table on). Proof. by case: {+}on. Qed.
Let ok' : table_ok 9 (hang_after on). Proof. by case: {+}on. Qed.

Let dart_inj i j : i < 9 -> j < 9 -> hang_dart i = hang_dart j -> i = j.
Proof. by apply: (patch_inj hang_label_inj ok _ _ _ hang_patch); case: {+}on. Qed.

Lemma hang_at : exists s', [/\ reach_in s 2 s', good s', hub s' a,
  forall e f, link_step s a e f -> e != (p, u) ->
    link_step s' a (change (u, q) (p, q) (third on u p q) (third_out on u p q) e)
      (change (p, u) (p, q) (third on u p q) (third_in on u p q) f) &
  link_step s' a (third_in on u p q) (third_out on u p q)].
Proof.
have par := hang_patch; have E := label_neqs hang_labels.
have [|s' [r gd' par' tw' out']] :=
    patch_run hang_label_inj dart_inj (p := hang_flips on) gd _ par; first by case: {+}on.
rewrite hang_afterE in par'.
have out_corners w : outside 9 hang_dart w -> corners s' w = corners s w.
  move=> ow; have ow1 := patch_outside_next wf ok par ow.
  have ow2 := patch_outside_next wf ok par ow1.
  have [n0 o0] := out' w ow; have [n1 o1] := out' _ ow1; have [n2 o2] := out' _ ow2.
  by rewrite /corners /corner /prev n0 n1 o0 o1 o2.
have old i : i < 9 -> corners s (hang_dart i) = (hang_label (tlabel (hang_table on) i),
    hang_label (tlabel (hang_table on) (tnext (hang_table on) i)),
    hang_label (tcorner (hang_table on) i)).
  by move=> lt_i; apply: patch_corners ok par lt_i.
have new i : i < 9 -> corners s' (hang_dart i) = (hang_label (tlabel (hang_after on) i),
    hang_label (tlabel (hang_after on) (tnext (hang_after on) i)),
    hang_label (tcorner (hang_after on) i)).
  by move=> lt_i; apply: patch_corners ok' par' lt_i.
have hub' : hub s' a.
  move=> w; case: (outsideP 9 hang_dart w) => [[i lt_i ->] | ow]; rewrite /at_face.
    have [-> -> ->] := new i lt_i; case: {+}on; move: i lt_i;
      by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /= !eqxx ?orbT.
  by have [-> -> ->] := out_corners w ow; apply: hub_a.
have not_in w i : outside 9 hang_dart w -> i < 9 -> corners s w != corners s (hang_dart i).
  by move=> ow lt_i; apply: contra (ow i lt_i) => /eqP /corners_inj->.
have to_hub d : origin s (next s d) = a -> d != d0 -> origin s' (next s' d) = a /\
    (corner s' d, origin s' d) =
      change (u, q) (p, q) (third on u p q) (third_out on u p q) (corner s d, origin s d).
  move=> nd d_d0; case: (outsideP 9 hang_dart d) => [[i lt_i def_d] | od].
    have cd := old i lt_i; have cd' := new i lt_i; move/eqP: nd d_d0; rewrite def_d.
    case: cd => -> -> ->; case: cd' => -> -> ->; case: {+}on; move: i lt_i {def_d};
      by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
        rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners d od; split=> //; rewrite /change.
  have := not_in d 5 od isT; have := not_in d 7 od isT; rewrite !old //; case: {+}on;
    rewrite /tcorner /tlabel /tnext /hang_label /= /corners nd !xpair_eqE eqxx /= !andbT;
    by rewrite andbC => /negbTE-> ; rewrite andbC => /negbTE->.
have from_hub w : origin s w = a -> w != t -> origin s' w = a /\
    (origin s' (next s' w), corner s' w) =
      change (p, u) (p, q) (third on u p q) (third_in on u p q) (origin s (next s w), corner s w).
  move=> ow_a w_t; case: (outsideP 9 hang_dart w) => [[i lt_i def_w] | ow].
    have cw := old i lt_i; have cw' := new i lt_i; move/eqP: ow_a w_t; rewrite def_w.
    case: cw => -> -> ->; case: cw' => -> -> ->; case: {+}on; move: i lt_i {def_w};
      by case=> [|[|[|[|[|[|[|[|[|i]]]]]]]]] // _; rewrite /tcorner /tlabel /tnext /hang_label /=;
        rewrite /change ?xpair_eqE ?eqxx ?E //= ?eqxx.
  have [-> -> ->] := out_corners w ow; split=> //; rewrite /change.
  have := not_in w 1 ow isT; have := not_in w 8 ow isT; rewrite !old //; case: {+}on;
    rewrite /tcorner /tlabel /tnext /hang_label /= /corners ow_a !xpair_eqE eqxx /=;
    by move=> /negbTE n8 /negbTE n1; rewrite n1 n8.
have wf' := good_wf gd'.
exists s'; split=> // [e f|].
  case/existsP => d /and3P[/eqP nd /eqP def_e /eqP def_f] e_X.
  have d_d0 : d != d0 by apply: contra e_X => /eqP dd; rewrite def_e dd e_p.
  have [nd' ends_d] := to_hub d nd d_d0.
  have [ot' ends_t] : origin s' (twin s d) = a /\ (origin s' (next s' (twin s d)),
      corner s' (twin s d)) = change (p, u) (p, q) (third on u p q) (third_in on u p q) f.
    rewrite def_f -(origin_next_twin wf d); apply: from_hub; first by rewrite (origin_twin wf).
    by rewrite (inj_eq (@twin_inj _ _ s)).
  apply/existsP; exists d; rewrite nd' eqxx /= {1}def_e ends_d eqxx /= -ends_t.
  by rewrite -(origin_next_twin wf' d) tw'.
have [_ _ t6] := par' 6 isT; apply/existsP; exists (hang_dart 6); move: t6 (new 6 isT).
have := new 2 isT; have := new 4 isT; rewrite tw'.
case: {+}on => -[_ n4 k4] [_ n2 k2] /(_ isT)-> [c6 n6 k6];
  by rewrite c6 n6 k6 ?k2 ?k4 /= !eqxx.
Qed.

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
Implicit Types (s : surface D V) (c r : seq (V * V)) (a u x y p q : V).

(* The walk in two parts, with the three edges that are changed at their ends. *)
Lemma hang_parts on s a w c r u p q : good s -> hub s a -> p != q -> contour s a w ->
    let e := third on u p q in
    perm_eq w ((p, u) :: (u, q) :: e :: c ++ r) -> link_step s a (p, u) (u, q) ->
    path (link_step s a) (u, q) (rcons c e) -> path (link_step s a) e (rcons r (p, u)) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a, size w = #|opposite s' a| &
    [/\ path (link_step s' a) (p, q) (rcons c (third_in on u p q)),
        link_step s' a (third_in on u p q) (third_out on u p q) &
        path (link_step s' a) (third_out on u p q) (rcons r (p, q))]].
Proof.
move=> gd hub_a pq con e perm_w; have [un _ sz] := con.
case/existsP => d /and3P[/eqP nd /eqP e_p /eqP[_ e_q]] walk1 walk2.
have [s' [r2 gd' hub' steps new]] := hang_at gd hub_a con on pq nd (esym e_p) (esym e_q).
have [n12 n13 n23 away] := three_apart un perm_w; rewrite -/e in steps.
have keep l e1 e1' e2' : {subset l <= c ++ r} -> e1 \in [:: (p, u); (u, q)] ->
    {in l, change e1 e1' e e2' =1 id}.
  move=> sub e1_in i /sub/away[n1 n2 n3]; apply: change_out => //.
  by move: e1_in; rewrite !inE => /orP[] /eqP->.
have free l f : {subset l <= c ++ r} -> (p, u) != f -> (p, u) \notin f :: l.
  by move=> sub f_pu; rewrite inE negb_or f_pu; apply/negP => /sub/away[/eqP].
have sub_c : {subset c <= c ++ r} by move=> i ic; rewrite mem_cat ic.
have sub_r : {subset r <= c ++ r} by move=> i ir; rewrite mem_cat ir orbT.
have change1 e1 e1' e2' : change e1 e1' e e2' e1 = e1' by rewrite /change eqxx.
have change2 e1 e1' e2' : e1 != e -> change e1 e1' e e2' e = e2'.
  by rewrite /change eq_sym eqxx => /negbTE->.
exists s'; split=> //.
  by rewrite sz !card_opposite //; apply: faces_darts (good_wf gd) (good_wf gd').
split=> //.
  rewrite -(change1 (u, q) (p, q) (third_out on u p q)) -(change2 _ (p, q) (third_in on u p q) n13).
  apply: path_change steps _ _ _ walk1; first exact: free.
    by apply: keep; rewrite // !inE eqxx orbT.
  by apply: keep; rewrite ?mem_head.
rewrite -(change1 (p, u) (p, q) (third_in on u p q)) -(change2 _ (p, q) (third_out on u p q) n23).
apply: path_change steps _ _ _ walk2; first exact: free.
  by apply: keep; rewrite // !inE eqxx orbT.
by apply: keep; rewrite ?mem_head.
Qed.

(* x comes before y: y is hung at x, behind what hangs there. *)
Theorem hang_back s a c r u x y : good s -> hub s a -> x != y ->
    contour s a ((x, u) :: (u, y) :: c ++ (y, u) :: r) ->
    uniq ((x, y) :: c ++ (y, x) :: (x, u) :: r) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a ((x, y) :: c ++ (y, x) :: (x, u) :: r)].
Proof.
move=> gd hub_a xy con un'; have [_ cyc _] := con.
move: cyc; rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons => /and3P[step walk1 walk2].
have [|s' [r2 gd' hub' sz [walk1' new walk2']]] :=
    hang_parts (on := false) gd hub_a xy con _ step walk1 walk2.
  by rewrite !perm_cons (perm_catCA c [:: (y, u)]).
exists s'; split=> //; split=> //; last by rewrite -sz /= !size_cat /= !addnS.
by rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons walk1' /= new.
Qed.

(* y comes before x: y is hung at x, in front of what hangs there. *)
Theorem hang_on s a c r u x y : good s -> hub s a -> x != y ->
    contour s a ((u, y) :: c ++ (y, u) :: (u, x) :: r) ->
    uniq ((u, x) :: (x, y) :: c ++ (y, x) :: r) ->
  exists s', [/\ reach_in s 2 s', good s', hub s' a &
    contour s' a ((u, x) :: (x, y) :: c ++ (y, x) :: r)].
Proof.
move=> gd hub_a xy con un'; have [_ cyc _] := con.
move: cyc; rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons => /and3P[walk2 step walk1].
rewrite eq_sym in xy; have [|s' [r2 gd' hub' sz [walk1' new walk2']]] :=
    hang_parts (on := true) gd hub_a xy con _ step walk1 walk2.
  by apply/seq.permP => i; rewrite /= !count_cat /=; ring.
exists s'; split=> //; split=> //; last by rewrite -sz /= !size_cat /= !addnS.
by rewrite /= rcons_cat /= -cat_rcons cat_path last_rcons new /=; apply/andP.
Qed.

End Words.

(* Theorem 4.3: any two loopless triangulations of the sphere with the same labels are joined by
   flips.

   First, being joined by flips is an equivalence.  [same_surface] (equal but for the names of the
   darts) is one; flips commute with it ([flip_same_surface]); flips can be taken back: exactly,
   since four flips of one edge are the identity ([reach_sym]), and as fast as they were done, but
   for the names of darts, since two flips exchange the darts of the edge ([reach_in_back]).
   Then the theorem: both surfaces are brought to a book with the same hubs, the pages of the one
   are sorted in the order of the other's, and equal books are equal surfaces. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants order reach star book equal_books sorting.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Equal but for the names of the darts: an equivalence. *)
Section SameSurface.

Variable V : finType.

Lemma same_surface_refl (D : finType) (s : surface D V) : same_surface s s.
Proof. by exists id; split=> //; exists id. Qed.

Lemma same_surface_sym (D D' : finType) (s : surface D V) (s' : surface D' V) :
  same_surface s s' -> same_surface s' s.
Proof.
case=> f [[g fK gK] ft fn fo]; exists g; split=> [|x|x|x]; first by exists f.
- by apply: (can_inj fK); rewrite ft !gK.
- by apply: (can_inj fK); rewrite fn !gK.
- by rewrite -fo gK.
Qed.

Lemma same_surface_trans (D1 D2 D3 : finType) (s1 : surface D1 V) (s2 : surface D2 V)
    (s3 : surface D3 V) :
  same_surface s1 s2 -> same_surface s2 s3 -> same_surface s1 s3.
Proof.
case=> f [f_bij ft fn fo] [g [g_bij gt gn go]]; exists (g \o f).
by split=> [|x|x|x]; [apply: bij_comp | rewrite /= ft gt | rewrite /= fn gn | rewrite /= go fo].
Qed.

Lemma same_surface_rename (D : finType) (s : surface D V) p : same_surface s (rename p s).
Proof.
exists p; split=> [|x|x|x]; rewrite /= ?permJ //; last by rewrite ffunE permK.
by exists p^-1%g; [apply: permK | apply: permKV].
Qed.

(* On one set of darts it is a permutation of them. *)
Lemma same_surfaceP (D : finType) (s s' : surface D V) :
  same_surface s s' <-> exists p, s' = rename p s.
Proof.
split=> [[f [f_bij ft fn fo]] | [p ->]]; last exact: same_surface_rename.
exists (perm (bij_inj f_bij)); apply: surface_eq => x; rewrite -[x](permKV (perm (bij_inj f_bij))).
- by rewrite permJ !permE ft.
- by rewrite permJ !permE fn.
- by rewrite ffunE permK permE fo.
Qed.

(* A flip does the same to the same surface under other names. *)
Theorem flip_same_surface (D D' : finType) (s : surface D V) (s' : surface D' V) h :
    good s -> good s' -> same_surface s s' -> allowed s h ->
  exists2 h', allowed s' h' & same_surface (flip h s) (flip h' s').
Proof.
move=> gd gd' [f [f_bij ft fn fo]] al; have f_inj := bij_inj f_bij.
have wf := good_wf gd; have wf' := good_wf gd'.
have fp x : f (prev s x) = prev s' (f x) by rewrite /prev !fn.
have fc x : corner s' (f x) = corner s x by rewrite /corner -fp fo.
have al' : allowed s' (f h) by rewrite /allowed -ft !fc.
exists (f h) => //; exists f; split=> [||x|x]; rewrite ?ft //.
  rewrite (flip_nextE wf (allowed_apart wf al)) (flip_nextE wf' (allowed_apart wf' al')).
  by rewrite -!(ft, fn, fp) !(inj_eq f_inj) !(fun_if f).
by rewrite !flip_originE -!(ft, fn, fp) !(inj_eq f_inj) !fc fo.
Qed.

End SameSurface.

Section Back.

Variable V : finType.

Lemma reach_in_same_surface (D D' : finType) (s : surface D V) (s' : surface D' V) n s1 :
    good s -> good s' -> same_surface s s' -> reach_in s n s1 ->
  exists2 s1', reach_in s' n s1' & same_surface s1 s1'.
Proof.
move=> gd gd' same r; elim: r s' gd gd' same => {s n s1} [s|s h n s1 al _ IH] s' gd gd' same.
  by exists s' => //; apply: reach_in0.
have [h' al' same1] := flip_same_surface gd gd' same al.
have [s1' r' same1'] := IH _ (flip_good gd al) (flip_good gd' al') same1.
by exists s1' => //; apply: reach_inS al' r'.
Qed.

Variable D : finType.
Implicit Types s : surface D V.

Lemma good_allowed_again s h : good s -> allowed s h -> allowed (flip h s) h.
Proof.
by case=> wf lf _ al; apply: flip_allowed (allowed_apart wf al) lf.
Qed.

(* Flips can be taken back, with as many flips, up to the names of darts. *)
Theorem reach_in_back s n s' : good s -> reach_in s n s' ->
  exists2 s'', reach_in s' n s'' & same_surface s'' s.
Proof.
move=> gd r; elim: r gd => {s n s'} [s|s h n s' al r IH] gd.
  by exists s; [apply: reach_in0 | apply: same_surface_refl].
have gd1 := flip_good gd al; have [s1 r1 same1] := IH gd1.
have gd1' := reach_in_good r1 (reach_in_good r gd1).
have [h' al' same2] :=
  flip_same_surface gd1 gd1' (same_surface_sym same1) (good_allowed_again gd al).
exists (flip h' s1); first by rewrite -addn1; apply: reach_in_trans r1 (reach_in1 al').
apply: same_surface_trans (same_surface_sym same2) _.
rewrite (flip_twice (good_wf gd)) ?(allowed_apart (good_wf gd)) //.
exact: same_surface_sym (same_surface_rename _ _).
Qed.

(* And exactly, with three flips for each. *)
Theorem reach_sym s s' : good s -> reach s s' -> reach s' s.
Proof.
move=> gd [n r]; elim: r gd => {s n s'} [s|s h n s' al _ IH] gd; first exact: reach_refl.
have gd1 := flip_good gd al; apply: reach_trans (IH gd1) _.
have al1 := good_allowed_again gd al; have gd2 := flip_good gd1 al1.
have al2 := good_allowed_again gd1 al1; have gd3 := flip_good gd2 al2.
have al3 := good_allowed_again gd2 al2.
rewrite -[s in reach _ s](flip_order_four (good_wf gd) (allowed_apart (good_wf gd) al)).
exists 3; apply: reach_inS al1 _; apply: reach_inS al2 _; apply: reach_inS al3 _.
exact: reach_in0.
Qed.

End Back.

(* Joined by n flips, up to the names of darts. *)
Definition joined_in (D D' V : finType) (s : surface D V) n (s' : surface D' V) :=
  exists2 s'', reach_in s n s'' & same_surface s'' s'.

(* Joined by flips, up to the names of darts: an equivalence. *)
Definition joined (D D' V : finType) (s : surface D V) (s' : surface D' V) :=
  exists n, joined_in s n s'.

Lemma joined_in_trans (D1 D2 D3 V : finType) (s1 : surface D1 V) (s2 : surface D2 V)
    (s3 : surface D3 V) n m : good s1 -> good s2 ->
  joined_in s1 n s2 -> joined_in s2 m s3 -> joined_in s1 (n + m) s3.
Proof.
move=> gd1 gd2 [t r12 same12] [u r23 same23].
have [u' ru sameu] :=
  reach_in_same_surface gd2 (reach_in_good r12 gd1) (same_surface_sym same12) r23.
exists u'; first exact: reach_in_trans r12 ru.
exact: same_surface_trans (same_surface_sym sameu) same23.
Qed.

Lemma joined_in_sym (D D' V : finType) (s : surface D V) (s' : surface D' V) n :
  good s -> good s' -> joined_in s n s' -> joined_in s' n s.
Proof.
move=> gd gd' [t r same]; have [u ru sameu] := reach_in_back gd r.
have [u' ru' sameu'] := reach_in_same_surface (reach_in_good r gd) gd' same ru.
by exists u' => //; apply: same_surface_trans (same_surface_sym sameu') sameu.
Qed.

Lemma joined_refl (D V : finType) (s : surface D V) : joined s s.
Proof. by exists 0, s; [apply: reach_in0 | apply: same_surface_refl]. Qed.

Lemma joined_sym (D D' V : finType) (s : surface D V) (s' : surface D' V) :
  good s -> good s' -> joined s s' -> joined s' s.
Proof. by move=> gd gd' [n j]; exists n; apply: joined_in_sym. Qed.

Lemma joined_trans (D1 D2 D3 V : finType) (s1 : surface D1 V) (s2 : surface D2 V)
    (s3 : surface D3 V) : good s1 -> good s2 ->
  joined s1 s2 -> joined s2 s3 -> joined s1 s3.
Proof.
by move=> gd1 gd2 [n j12] [m j23]; exists (n + m); apply: joined_in_trans j12 j23.
Qed.

(* A sphere has an edge, hence two different labels, to be the hubs of a book. *)
Lemma sphere_hubs (D V : finType) (s : surface D V) :
  good s -> sphere s -> exists ab : V * V, ab.1 != ab.2.
Proof.
move=> gd sph; have wf := good_wf gd; have v_pos : 0 < #|V|.
  by have := sphere_faces wf sph; rewrite addn4; case: #|V|.
have [v _] := card_gt0P v_pos; have [x _] := label_used wf v.
by exists (origin s x, origin s (next s x)); apply: good_loopless.
Qed.

(* From a sphere to a book with given hubs, with its pages in some order. *)
Lemma to_book (D V : finType) (s : surface D V) (a b : V) : good s -> sphere s -> a != b ->
  exists n s' c, [/\ reach_in s n s', book s' a b, page_order s' a b c & n + 12 <= 4 * #|V|].
Proof.
move=> gd sph ab; have ba : b != a by rewrite eq_sym.
have [n [s' [r gd' bk _ le_n]]] := star_sphere gd sph ba.
have thin := book_narrow gd' (reach_in_sphere r gd sph) ab bk.
have [c order_c] := page_order_exists (good_wf gd') (good_loopless gd') ab bk thin.
by exists n, s', c.
Qed.

(* As many pages as labels besides the hubs. *)
Lemma size_page_order (D V : finType) (s : surface D V) (a b : V) c :
  a != b -> page_order s a b c -> size c = #|V| - 2.
Proof.
move=> ab [un cV _]; rewrite -(card_uniqP un) -(cardC (pred2 a b)) card2 ab addKn.
by apply: eq_card => p; rewrite cV !inE negb_or.
Qed.

(* Theorem 4.3, with a bound: two loopless triangulations of the sphere with the same labels, on
   darts of their own, are joined by at most 4 k (k - 1) / 2 + 8 k - 8 flips, where k = V - 2. *)
Theorem theorem_4_3_in (D D' V : finType) (s : surface D V) (s' : surface D' V) :
    good s -> good s' -> sphere s -> sphere s' ->
  exists2 n, joined_in s n s' & n + 24 <= 8 * #|V| + 4 * 'C(#|V| - 2, 2).
Proof.
move=> gd gd' sph sph'; have [[a b] /= ab] := sphere_hubs gd sph.
have [n [t [c [r bk order_c le_n]]]] := to_book gd sph ab.
have [n' [t' [c' [r' bk' order_c' le_n']]]] := to_book gd' sph' ab.
have perm_c : perm_eq c c'.
  have [un cV _] := order_c; have [un' cV' _] := order_c'.
  by apply: uniq_perm => // p; rewrite cV cV'.
have gdt := reach_in_good r gd; have gdt' := reach_in_good r' gd'.
have spht := reach_in_sphere r gd sph; have spht' := reach_in_sphere r' gd' sph'.
have [m [u [le_m ru bku order_u]]] := sort gdt spht ab bk order_c perm_c.
rewrite (size_page_order ab order_c) in le_m.
have gdu := reach_in_good ru gdt; have sphu := reach_in_sphere ru gdt spht.
have same : same_surface u t'.
  apply: (equal_books_order (good_wf gdu) (good_wf gdt') _ _ ab bku bk' _ _ order_u order_c').
  - exact: good_loopless.
  - exact: good_loopless.
  - exact: book_narrow.
  - exact: book_narrow.
have to_t' : joined_in s (n + m) t' by exists u; first exact: reach_in_trans r ru.
have back : joined_in t' n' s'.
  by apply: joined_in_sym => //; exists t' => //; apply: same_surface_refl.
exists (n + m + n'); first exact: joined_in_trans to_t' back.
move: le_n le_n' le_m; set v := #|V|; set w := 'C(_, _) => le_n le_n' le_m.
have -> : n + m + n' + 24 = (n + 12) + (n' + 12) + m.
  by rewrite [(n + 12) + _]addnACA [n + m + n']addnAC [LHS]addnAC.
by apply: leq_add => //; rewrite -[8]/(4 + 4) mulnDl; apply: leq_add.
Qed.

(* Theorem 4.3: any two loopless triangulations of the sphere with the same labels are joined by
   flips.  (V >= 4 is not asked for: with three labels there is one triangulation.) *)
Theorem theorem_4_3 (D D' V : finType) (s : surface D V) (s' : surface D' V) :
  good s -> good s' -> sphere s -> sphere s' -> joined s s'.
Proof.
by move=> gd gd' sph sph'; have [n jn _] := theorem_4_3_in gd gd' sph sph'; exists n.
Qed.

(* The same where both have the same darts: flips lead from s to s' with its darts renamed. *)
Corollary theorem_4_3_same_darts (D V : finType) (s s' : surface D V) :
  good s -> good s' -> sphere s -> sphere s' -> exists p : {perm D}, reach s (rename p s').
Proof.
move=> gd gd' sph sph'; have [n [u r same]] := theorem_4_3 gd gd' sph sph'.
by have [p def_u] := (same_surfaceP _ _).1 (same_surface_sym same); exists p, n; rewrite -def_u.
Qed.

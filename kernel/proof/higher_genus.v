(* Beyond the sphere: with three vertices flips do not join what has the same genus.

   In a surface without loops that has three vertices both corners opposite to an edge are the
   third vertex, so no flip is allowed, whatever the genus ([three_vertices_no_flip]): flips lead
   nowhere ([three_vertices_alone]).  On the sphere and on the torus that does no harm, but
   from genus 2 on there are several such surfaces.  Two of genus 2 and two of genus 3 are given
   here as tables; that they are what is said, and different whatever their darts and vertices
   are called, is found by calculation ([genus_2_not_joined], [genus_3_not_joined]).  For labelled
   surfaces of every genus from 2 on see every_genus.v. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants reach.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section ThreeVertices.

Variables D V : finType.
Implicit Types (s : surface D V) (h : D).
Hypothesis three : #|V| = 3.

Theorem three_vertices_no_flip s h : well_formed s -> loopless s -> ~~ allowed s h.
Proof.
move=> wf loopl; rewrite /allowed negbK; apply: contraT => cc'.
have ends x : [/\ origin s x != origin s (next s x), corner s x != origin s x &
    corner s x != origin s (next s x)].
  split; [exact: loopl| |by rewrite eq_sym; apply: loopl].
  by have := loopl (prev s x); rewrite (prevK wf).
have [n1 n2 n3] := ends h; have [_ m2 m3] := ends (twin s h).
rewrite origin_twin // origin_next_twin // in m2 m3.
pose vs := [:: origin s h; origin s (next s h); corner s h; corner s (twin s h)].
have uniq_vs : uniq vs.
  rewrite /= !inE !negb_or n1 [_ == corner s h]eq_sym n2 [_ == corner s (twin s h)]eq_sym m3.
  by rewrite [_ == corner s h]eq_sym n3 [_ == corner s (twin s h)]eq_sym m2 cc'.
by have := max_card (mem vs); rewrite (card_uniqP uniq_vs) three.
Qed.

Theorem three_vertices_alone s s' : well_formed s -> loopless s -> reach s s' -> s' = s.
Proof.
move=> wf loopl [n r]; case: n s' / r => // h m s' ok _.
by rewrite (negbTE (three_vertices_no_flip h wf loopl)) in ok.
Qed.

End ThreeVertices.

(* The same gluing, whatever the darts and the vertices are called. *)
Definition same_gluing (D D' V V' : finType) (s : surface D V) (s' : surface D' V') :=
  exists f : D -> D', [/\ bijective f, forall x, f (twin s x) = twin s' (f x) &
    forall x, f (next s x) = next s' (f x)].

Lemma same_surface_gluing (D D' V : finType) (s : surface D V) (s' : surface D' V) :
  same_surface s s' -> same_gluing s s'.
Proof. by case=> f [bij_f f_twin f_next _]; exists f. Qed.

(* Going from dart to dart: true leads to the next one, false to the twin. *)
Fixpoint walk (D V : finType) (s : surface D V) (w : seq bool) x :=
  if w is c :: w' then walk s w' (if c then next s x else twin s x) else x.

(* What leads back to its start in a surface does so in every one with the same gluing. *)
Lemma walk_apart (D D' V V' : finType) (s : surface D V) (s' : surface D' V') w x :
  walk s w x = x -> (forall y, walk s' w y != y) -> ~ same_gluing s s'.
Proof.
move=> back astray [f [_ f_twin f_next]].
have f_walk u z : f (walk s u z) = walk s' u (f z).
  by elim: u z => //= c u IHu z; rewrite IHu; case: c; rewrite ?f_twin ?f_next.
by have := astray (f x); rewrite -f_walk back eqxx.
Qed.

(* Surfaces from tables: dart i has the twin i + 1 or i - 1, whichever belongs to its pair, and the
   table has next and origin of each dart.  The vertices are 0, 1 and 2. *)
Section Table.

Variables (n : nat) (table : seq (nat * nat)).

Let entry i := nth (0, 0) table i.
Let tw i := if odd i then i.-1 else i.+1.
Let nx i := (entry i).1.
Let og i := (entry i).2.
Let turn i := nx (tw i).

(* All darts that are reached from dart i in k rounds. *)
Fixpoint around k (xs : seq nat) :=
  if k is k'.+1 then around k' (undup (xs ++ map tw xs ++ map nx xs)) else xs.

(* Everything is in order, by calculation; all darts are reached in so many rounds. *)
Definition table_ok rounds :=
  let darts := iota 0 n.+1 in
  [&& all (fun i => [&& tw i <= n, nx i <= n & og i < 3]) darts,
      all (fun i => [&& nx (nx (nx i)) == i, nx i != i, og (turn i) == og i & og i != og (nx i)])
        darts,
      all (fun i => all (fun j => (og i == og j) ==> (j \in traject turn i n)) darts) darts,
      all (fun v => has (fun i => og i == v) darts) (iota 0 3) &
      all (fun i => let reached := around rounds [:: i] in all (mem reached) darts) darts].

Variable rounds : nat.
Hypothesis ok : table_ok rounds.

Implicit Types i j : 'I_n.+1.

Let dart i : val i \in iota 0 n.+1. Proof. by rewrite mem_iota ltn_ord. Qed.

Let in_range i : [/\ tw i <= n, nx i <= n & og i < 3].
Proof. by have [/allP/(_ _ (dart i))/and3P] := and5P ok. Qed.

Let entry_ok i : [/\ nx (nx (nx i)) = i, nx i != i, og (turn i) = og i & og i != og (nx i)].
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

Definition table_surface : surface [finType of 'I_n.+1] [finType of 'I_3] :=
  Surface (perm twin_of_inj) (perm next_of_inj) [ffun i : 'I_n.+1 => inord (og i)].

Let s := table_surface.

Let twinE i : val (twin s i) = tw i. Proof. by rewrite permE twin_ofE. Qed.
Let nextE i : val (next s i) = nx i. Proof. by rewrite permE next_ofE. Qed.
Let originE i : val (origin s i) = og i.
Proof. by have [_ _ ?] := in_range i; rewrite ffunE /= inordK. Qed.
Let sigma_val k i : val ((sigma s ^+ k)%g i) = iter k turn i.
Proof.
elim: k => [|k IHk]; first by rewrite expg0 perm1.
by rewrite expgSr permM sigmaE nextE twinE IHk.
Qed.

Lemma table_good : good s.
Proof.
have [_ _ orbits used reached] := and5P ok; split.
- split=> [i|i|i|i|i j|v].
  + by apply: val_inj; rewrite !twinE tw_tw.
  + by rewrite -val_eqE twinE tw_neq.
  + by apply: val_inj; rewrite !nextE; have [-> _ _ _] := entry_ok i.
  + by rewrite -val_eqE nextE; have [_ -> _ _] := entry_ok i.
  + apply/eqP/idP => [eq_o|/porbitP[k ->]].
      have /allP/(_ _ (dart i))/allP/(_ _ (dart j)) := orbits; rewrite -!originE eq_o eqxx /=.
      case/trajectP => k _ def_j; apply/porbitP; exists k; apply: val_inj.
      by rewrite sigma_val.
    elim: k => [|k ->]; first by rewrite expg0 perm1.
    rewrite expgSr permM sigmaE; set j' := _ i; apply: val_inj; rewrite !originE nextE twinE.
    by have [_ _ -> _] := entry_ok j'.
  + have /allP/(_ (val v)) := used; rewrite mem_iota ltn_ord => /(_ isT) /hasP[k].
    rewrite mem_iota => /andP[_ le_kn] /eqP def_v; exists (Ordinal le_kn).
    by apply: val_inj; rewrite originE.
- by move=> i; rewrite -val_eqE !originE nextE; have [_ _ _ ->] := entry_ok i.
move=> i j; have /allP/(_ _ (dart i))/allP/(_ _ (dart j)) := reached.
have: forall k, k \in [:: val i] -> exists2 x, val x = k & connect (link s) i x.
  by move=> k; rewrite inE => /eqP->; exists i.
elim: rounds [:: val i] => [|r IHr] xs conn /=.
  by move/conn => [x /val_inj-> ].
apply: IHr => k; rewrite mem_undup !mem_cat => /or3P[/conn //| | ] /mapP[m /conn[x <- ix] ->].
  exists (twin s x); first exact: twinE.
  by apply: connect_trans ix (connect1 _); rewrite /link eqxx.
exists (next s x); first exact: nextE.
by apply: connect_trans ix (connect1 _); rewrite /link eqxx orbT.
Qed.

Lemma table_genus g : n.+1 = 6 * (2 * g).+1 -> has_genus s g.
Proof.
have [wf _ conn] := table_good => card_D; split=> //.
have -> : edges s = 3 * (2 * g).+1.
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 2)) edges2 // card_ord card_D mulnAC.
have -> : faces s = 2 * (2 * g).+1.
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) faces3 // card_ord card_D mulnAC.
by rewrite vertices_labels // card_ord; ring.
Qed.

Fixpoint walk_table (w : seq bool) k :=
  if w is c :: w' then walk_table w' (if c then nx k else tw k) else k.

Lemma walk_table_val w i : val (walk s w i) = walk_table w i.
Proof. by elim: w i => //= c w IHw i; rewrite IHw; case: c; rewrite ?nextE ?twinE. Qed.

End Table.

Lemma tables_apart n table r (ok : table_ok n table r) n' table' r' (ok' : table_ok n' table' r')
    w :
  walk_table table w 0 == 0 -> all (fun i => walk_table table' w i != i) (iota 0 n'.+1) ->
  ~ same_gluing (table_surface ok) (table_surface ok').
Proof.
move=> /eqP back /allP astray; apply: (@walk_apart _ _ _ _ _ _ w ord0).
  by apply: val_inj; rewrite walk_table_val.
by move=> y; rewrite -val_eqE walk_table_val; apply: astray; rewrite mem_iota ltn_ord.
Qed.

(* Two of genus 2.  The tables are genus-2-isolated-1.txt and -2.txt in docs/findings.
   The way tntntnntntntnn (t to the twin, n to the next dart) leads back to its start from
   dart 0 of the first one, and from no dart of the second. *)
Definition genus_2_first_table : seq (nat * nat) :=
  [:: (2, 0); (6, 1); (4, 1); (10, 2); (0, 2); (14, 0); (8, 0); (18, 2); (1, 2); (20, 1); (12, 1);
      (22, 0); (3, 0); (26, 2); (16, 2); (7, 1); (5, 1); (9, 0); (15, 0); (25, 1); (17, 2);
      (23, 0); (24, 1); (27, 2); (11, 2); (29, 0); (28, 0); (21, 1); (13, 1); (19, 2)].

Definition genus_2_second_table : seq (nat * nat) :=
  [:: (2, 0); (6, 1); (4, 1); (10, 2); (0, 2); (14, 0); (8, 0); (18, 2); (1, 2); (20, 1); (12, 1);
      (24, 0); (3, 0); (17, 2); (16, 2); (7, 1); (5, 1); (28, 0); (15, 0); (21, 1); (22, 2);
      (25, 0); (9, 0); (27, 1); (26, 1); (19, 2); (11, 2); (29, 0); (13, 1); (23, 2)].

Lemma genus_2_first_ok : table_ok 29 genus_2_first_table 12. Proof. by vm_compute. Qed.
Definition genus_2_first := table_surface genus_2_first_ok.
Lemma genus_2_second_ok : table_ok 29 genus_2_second_table 12. Proof. by vm_compute. Qed.
Definition genus_2_second := table_surface genus_2_second_ok.

Lemma genus_2_apart : ~ same_gluing genus_2_first genus_2_second.
Proof.
pose way := [:: false; true; false; true; false; true; true; false; true; false; true; false; true;
                true].
by apply: (tables_apart (w := way)); vm_compute.
Qed.

Theorem genus_2_not_joined :
  [/\ good genus_2_first /\ has_genus genus_2_first 2,
      good genus_2_second /\ has_genus genus_2_second 2 &
      forall s, reach genus_2_first s -> ~ same_gluing s genus_2_second].
Proof.
split; try by [split; [exact: table_good|exact: table_genus]].
have [wf loopl _] := table_good genus_2_first_ok => s r.
by rewrite (three_vertices_alone (card_ord 3) wf loopl r); apply: genus_2_apart.
Qed.

(* Two of genus 3.
   The way ntntnntntnntntn (t to the twin, n to the next dart) leads back to its start from
   dart 0 of the first one, and from no dart of the second. *)
Definition genus_3_first_table : seq (nat * nat) :=
  [:: (14, 0); (39, 1); (16, 0); (41, 1); (18, 0); (29, 1); (20, 0); (31, 1); (22, 0); (33, 1);
      (24, 0); (35, 1); (26, 0); (37, 1); (28, 1); (3, 2); (30, 1); (5, 2); (32, 1); (7, 2);
      (34, 1); (9, 2); (36, 1); (11, 2); (38, 1); (13, 2); (40, 1); (1, 2); (0, 2); (17, 0);
      (2, 2); (19, 0); (4, 2); (21, 0); (6, 2); (23, 0); (8, 2); (25, 0); (10, 2); (27, 0);
      (12, 2); (15, 0)].

Definition genus_3_second_table : seq (nat * nat) :=
  [:: (14, 0); (31, 1); (16, 0); (35, 1); (18, 0); (29, 1); (20, 0); (39, 1); (22, 0); (33, 1);
      (24, 0); (41, 1); (26, 0); (37, 1); (28, 1); (3, 2); (30, 1); (5, 2); (32, 1); (7, 2);
      (34, 1); (9, 2); (36, 1); (11, 2); (38, 1); (13, 2); (40, 1); (1, 2); (0, 2); (17, 0);
      (2, 2); (27, 0); (4, 2); (21, 0); (6, 2); (15, 0); (8, 2); (25, 0); (10, 2); (19, 0);
      (12, 2); (23, 0)].

Lemma genus_3_first_ok : table_ok 41 genus_3_first_table 12. Proof. by vm_compute. Qed.
Definition genus_3_first := table_surface genus_3_first_ok.
Lemma genus_3_second_ok : table_ok 41 genus_3_second_table 12. Proof. by vm_compute. Qed.
Definition genus_3_second := table_surface genus_3_second_ok.

Lemma genus_3_apart : ~ same_gluing genus_3_first genus_3_second.
Proof.
pose way := [:: true; false; true; false; true; true; false; true; false; true; true; false; true;
                false; true].
by apply: (tables_apart (w := way)); vm_compute.
Qed.

Theorem genus_3_not_joined :
  [/\ good genus_3_first /\ has_genus genus_3_first 3,
      good genus_3_second /\ has_genus genus_3_second 3 &
      forall s, reach genus_3_first s -> ~ same_gluing s genus_3_second].
Proof.
split; try by [split; [exact: table_good|exact: table_genus]].
have [wf loopl _] := table_good genus_3_first_ok => s r.
by rewrite (three_vertices_alone (card_ord 3) wf loopl r); apply: genus_3_apart.
Qed.

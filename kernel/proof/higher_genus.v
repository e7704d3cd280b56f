(* Beyond the sphere: with three vertices flips do not join what has the same genus.

   In a surface without loops that has three vertices both corners opposite to an edge are the
   third vertex, so no flip is allowed, whatever the genus ([three_vertices_no_flip]): flips lead
   nowhere ([three_vertices_alone]).  On the sphere and on the torus that does no harm, but
   from genus 2 on there are several such surfaces.  Two of genus 2 and two of genus 3 are given
   here as tables; that they are what is said, and different whatever their darts and vertices
   are called, is found by calculation ([genus_2_not_joined], [genus_3_not_joined]).  For labelled
   surfaces of every genus from 2 on see every_genus.v. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants reach numbered.

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

(* What leads back to its start in a surface does so in every one with the same gluing. *)
Lemma walk_apart (D D' V V' : finType) (s : surface D V) (s' : surface D' V') w x :
  walk s w x = x -> (forall y, walk s' w y != y) -> ~ same_gluing s s'.
Proof.
move=> back astray [f [_ f_twin f_next]].
have f_walk u z : f (walk s u z) = walk s' u (f z).
  by elim: u z => //= c u IHu z; rewrite IHu; case: c; rewrite ?f_twin ?f_next.
by have := astray (f x); rewrite -f_walk back eqxx.
Qed.

(* Surfaces from tables, which have next and origin of each dart.  The vertices are 0, 1 and 2. *)
Definition table_next (table : seq (nat * nat)) i := (nth (0, 0) table i).1.
Definition table_origin (table : seq (nat * nat)) i := (nth (0, 0) table i).2.

Section Table.

Variables (n : nat) (table : seq (nat * nat)).

Let og := table_origin table.
Let turn i := table_next table (mate i).

(* Everything is in order, by calculation; all darts are reached in so many rounds. *)
Definition table_ok rounds :=
  let darts := iota 0 n.+1 in
  [&& numbered_ok n 2 (table_next table) og rounds,
      all (fun i => og (turn i) == og i) darts &
      all (fun i => all (fun j => (og i == og j) ==> (j \in traject turn i n)) darts) darts].

Variable rounds : nat.
Hypothesis ok : table_ok rounds.

Let in_order : numbered_ok n 2 (table_next table) og rounds. Proof. by case/and3P: ok. Qed.

Definition table_surface : surface [finType of 'I_n.+1] [finType of 'I_3] := numbered in_order.

Let s := table_surface.

Let originE i : val (origin s i) = og i. Proof. exact: numbered_origin. Qed.
Let sigmaE' i : val (sigma s i) = turn (val i).
Proof. by rewrite sigmaE [LHS]numbered_next numbered_twin. Qed.
Let sigma_val k i : val ((sigma s ^+ k)%g i) = iter k turn (val i).
Proof.
elim: k => [|k IHk]; first by rewrite expg0 perm1.
by rewrite expgSr permM sigmaE' IHk.
Qed.

Lemma table_good : good s.
Proof.
have [_ /allP constant orbits] := and3P ok.
split; [split=> [|||| i j|] | exact: numbered_loopless | exact: numbered_connected].
- exact: numbered_twinK.
- exact: numbered_twin_neq.
- exact: numbered_next3.
- exact: numbered_next_neq.
- apply/eqP/idP => [eq_o|/porbitP[k ->]].
    have /allP/(_ _ (dart_number i))/allP/(_ _ (dart_number j)) := orbits.
    rewrite -!originE eq_o eqxx /=.
    case/trajectP => k _ def_j; apply/porbitP; exists k; apply: val_inj.
    by rewrite sigma_val.
  elim: k => [|k ->]; first by rewrite expg0 perm1.
  rewrite expgSr permM; set j' := _ i; apply: val_inj; rewrite !originE sigmaE'.
  by rewrite (eqP (constant _ (dart_number j'))).
exact: numbered_used.
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

End Table.

(* Two surfaces of genus g that flips do not join: a way that leads back to its start from dart 0
   of the first one does so from no dart of the second. *)
Lemma tables_not_joined n table table' r r' (ok : table_ok n table r) (ok' : table_ok n table' r')
    g w :
  n.+1 = 6 * (2 * g).+1 -> walk_numbers (table_next table) w 0 == 0 ->
  all (fun i => walk_numbers (table_next table') w i != i) (iota 0 n.+1) ->
  [/\ good (table_surface ok) /\ has_genus (table_surface ok) g,
      good (table_surface ok') /\ has_genus (table_surface ok') g &
      forall s, reach (table_surface ok) s -> ~ same_gluing s (table_surface ok')].
Proof.
move=> card_n /eqP back /allP astray.
split; try by [split; [exact: table_good|exact: table_genus]].
have [wf loopl _] := table_good ok => s r_s.
rewrite (three_vertices_alone (card_ord 3) wf loopl r_s).
apply: (@walk_apart _ _ _ _ _ _ w ord0); first by apply: val_inj; rewrite [LHS]numbered_walk.
by move=> y; rewrite -val_eqE [X in X != _]numbered_walk; apply: astray; apply: dart_number.
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

Theorem genus_2_not_joined :
  [/\ good genus_2_first /\ has_genus genus_2_first 2,
      good genus_2_second /\ has_genus genus_2_second 2 &
      forall s, reach genus_2_first s -> ~ same_gluing s genus_2_second].
Proof.
pose way := [:: false; true; false; true; false; true; true; false; true; false; true; false; true;
                true].
by apply: (tables_not_joined genus_2_first_ok genus_2_second_ok (w := way)); vm_compute.
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

Theorem genus_3_not_joined :
  [/\ good genus_3_first /\ has_genus genus_3_first 3,
      good genus_3_second /\ has_genus genus_3_second 3 &
      forall s, reach genus_3_first s -> ~ same_gluing s genus_3_second].
Proof.
pose way := [:: true; false; true; false; true; true; false; true; false; true; true; false; true;
                false; true].
by apply: (tables_not_joined genus_3_first_ok genus_3_second_ok (w := way)); vm_compute.
Qed.

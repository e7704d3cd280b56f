(* What a triangulated surface is, as two permutations of darts and a label per dart.

   A dart is a side of a face, with its direction.  [twin] leads to the same edge seen from
   the face behind it, [next] to the following side of the same face, and [origin] is the name of
   the vertex where the dart starts.  Turning about a vertex is [sigma] = next after twin.

   [well_formed]: twin is an involution without fixed point, all cycles of next have length three,
   two darts have the same label exactly where they start at the same vertex (lie in one orbit of
   sigma), and every label is used.  Nothing here says that a surface is connected, free of
   loops or a sphere: those are properties of their own, below.

   This file has the definitions and the small facts that every other file needs. *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Record surface (D V : finType) :=
  Surface { twin : {perm D}; next : {perm D}; origin : {ffun D -> V} }.

Section Definitions.

Variables D V : finType.
Implicit Types (s : surface D V) (x y h : D).

(* The third side of the face of x. *)
Definition prev s x := next s (next s x).

(* Turning about the vertex where x starts: sigma x = next (twin x). *)
Definition sigma s : {perm D} := (twin s * next s)%g.

Record well_formed s : Prop := WellFormed {
  twinK : involutive (twin s);
  twin_neq : forall x, twin s x != x;
  next3 : forall x, next s (next s (next s x)) = x;
  next_neq : forall x, next s x != x;
  label_orbit : forall x y, (origin s x == origin s y) = (y \in porbit (sigma s) x);
  label_used : forall v, exists x, origin s x = v }.

(* No edge joins a vertex to itself. *)
Definition loopless s := forall x, origin s x != origin s (next s x).

(* Every dart is reached from every other across edges and along faces. *)
Definition link s : rel D := fun x y => (y == twin s x) || (y == next s x).
Definition connected s := forall x y, connect (link s) x y.

(* The face of x, and two darts of one face. *)
Definition same_face s x y := y \in porbit (next s) x.

(* At most two of the three faces beside a face coincide. *)
Definition three_neighbour s := forall x,
  ~~ (same_face s (twin s x) (twin s (next s x)) && same_face s (twin s x) (twin s (prev s x))).

(* The numbers of vertices, edges and faces, as numbers of orbits. *)
Definition vertices s := #|porbits (sigma s)|.
Definition edges s := #|porbits (twin s)|.
Definition faces s := #|porbits (next s)|.

(* The Euler characteristic, and the sphere among the connected surfaces. *)
Definition euler s : int := ((vertices s)%:Z - (edges s)%:Z + (faces s)%:Z)%R.
Definition sphere s := connected s /\ vertices s + faces s = edges s + 2.
Definition has_genus s (g : nat) :=
  connected s /\ vertices s + faces s + 2 * g = edges s + 2.

(* The opposite corner of the face of x, and the guard of the flip: the two corners opposite to an
   edge differ. *)
Definition corner s x := origin s (prev s x).
Definition allowed s h := corner s h != corner s (twin s h).

End Definitions.

(* The same labelled surface, whatever the darts are called. *)
Definition same_surface (D D' V : finType) (s : surface D V) (s' : surface D' V) :=
  exists f : D -> D', [/\ bijective f,
    forall x, f (twin s x) = twin s' (f x),
    forall x, f (next s x) = next s' (f x) &
    forall x, origin s' (f x) = origin s x].

(* Equal tables are equal surfaces. *)
Lemma surface_eq (D V : finType) (s s' : surface D V) :
  twin s =1 twin s' -> next s =1 next s' -> origin s =1 origin s' -> s = s'.
Proof.
case: s s' => [t n o] [t' n' o'] /= eq_t eq_n eq_o.
by congr Surface; [apply/permP|apply/permP|apply/ffunP].
Qed.

(* Orbits: one step, and what is constant on each step. *)
Lemma porbit_step (D : finType) (p : {perm D}) x : p x \in porbit p x.
Proof. by have := mem_porbit p 1 x; rewrite expg1. Qed.

Lemma porbit_invariant (D : finType) (T : Type) (p : {perm D}) (f : D -> T) x y :
  (forall z, f (p z) = f z) -> y \in porbit p x -> f y = f x.
Proof.
move=> inv /porbitP[n ->]; elim: n => [|n IHn]; first by rewrite expg0 perm1.
by rewrite expgSr permM inv.
Qed.

Section Basics.

Variables D V : finType.
Variable s : surface D V.
Implicit Types x y : D.

Lemma sigmaE x : sigma s x = next s (twin s x).
Proof. by rewrite permM. Qed.

Lemma twin_inj : injective (twin s). Proof. exact: perm_inj. Qed.
Lemma next_inj : injective (next s). Proof. exact: perm_inj. Qed.
Lemma sigma_inj : injective (sigma s). Proof. exact: perm_inj. Qed.

Lemma prev_inj : injective (prev s).
Proof. by move=> x y /next_inj /next_inj. Qed.

Lemma mem_sigma_orbit x : next s (twin s x) \in porbit (sigma s) x.
Proof. by rewrite -sigmaE porbit_step. Qed.

(* Lying in one face is an equivalence. *)
Lemma same_face_refl x : same_face s x x. Proof. exact: porbit_id. Qed.

Lemma same_face_sym x y : same_face s x y = same_face s y x.
Proof. exact: porbit_sym. Qed.

Lemma same_face_trans y x z : same_face s x y -> same_face s y z -> same_face s x z.
Proof. by rewrite /same_face -!eq_porbit_mem => /eqP-> /eqP->. Qed.

Lemma same_face_next x y : same_face s x (next s y) = same_face s x y.
Proof.
by rewrite /same_face -!eq_porbit_mem; have := porbit_perm (next s) 1 y; rewrite expg1 => ->.
Qed.

Hypothesis wf : well_formed s.

Lemma nextK : cancel (next s) (prev s). Proof. exact: (next3 wf). Qed.
Lemma prevK : cancel (prev s) (next s). Proof. exact: (next3 wf). Qed.

Lemma next_next_neq x : next s (next s x) != x.
Proof.
apply/negP => /eqP nnx; move: (next3 wf x); rewrite nnx => /eqP.
by rewrite (negbTE (next_neq wf x)).
Qed.

Lemma prev_neq x : prev s x != x. Proof. exact: next_next_neq. Qed.

Lemma prev_next_neq x : prev s x != next s x.
Proof. exact: next_neq. Qed.

Lemma next_neq' x : x != next s x. Proof. by rewrite eq_sym next_neq. Qed.
Lemma prev_neq' x : x != prev s x. Proof. by rewrite eq_sym prev_neq. Qed.
Lemma twin_neq' x : x != twin s x. Proof. by rewrite eq_sym twin_neq. Qed.

(* The labels at the ends of a dart. *)
Lemma origin_next_twin x : origin s (next s (twin s x)) = origin s x.
Proof. by apply/esym/eqP; rewrite (label_orbit wf) mem_sigma_orbit. Qed.

Lemma origin_twin x : origin s (twin s x) = origin s (next s x).
Proof. by rewrite -(origin_next_twin (twin s x)) (twinK wf). Qed.

Lemma origin_twin_prev x : origin s (twin s (prev s x)) = origin s x.
Proof. by rewrite origin_twin prevK. Qed.

Lemma label_orbitP x y : reflect (origin s x = origin s y) (y \in porbit (sigma s) x).
Proof. by rewrite -(label_orbit wf); apply: eqP. Qed.

(* Steps can be undone, so reaching is symmetric. *)
Lemma link_sym : connect_sym (link s).
Proof.
have back : subrel (link s) [rel x y | connect (link s) y x].
  move=> x y /orP[] /eqP-> /=.
    by apply: connect1; rewrite /link (twinK wf) eqxx.
  rewrite -{2}(next3 wf x); apply: (connect_trans (y := next s (next s x))).
    by apply: connect1; rewrite /link eqxx orbT.
  by apply: connect1; rewrite /link eqxx orbT.
suff sub x y : connect (link s) x y -> connect (link s) y x.
  by move=> x y; apply/idP/idP; apply: sub.
case/connectP=> p; elim: p x => [|z p IHp] x /= => [_ ->|/andP[xz zp] def_y]; first exact: connect0.
exact: connect_trans (IHp z zp def_y) (back _ _ xz).
Qed.

(* A face is its three darts. *)
Lemma in_face x y :
  (y \in porbit (next s) x) = [|| y == x, y == next s x | y == prev s x].
Proof.
apply/porbitP/or3P => [[n ->]|].
  elim: n => [|n IHn]; first by rewrite expg0 perm1; constructor 1.
  rewrite expgSr permM; case: IHn => /eqP->.
  - by constructor 2.
  - by constructor 3.
  - by rewrite prevK; constructor 1.
case=> /eqP->.
- by exists 0; rewrite expg0 perm1.
- by exists 1; rewrite expg1.
- by exists 2; rewrite expgS expg1 permM.
Qed.

Lemma same_faceE x y :
  same_face s x y = [|| y == x, y == next s x | y == prev s x].
Proof. exact: in_face. Qed.

Lemma face_set x : porbit (next s) x = [set x; next s x; prev s x].
Proof. by apply/setP => y; rewrite in_face !inE orbA. Qed.

Lemma card_face x : #|porbit (next s) x| = 3.
Proof.
rewrite face_set setUC cardsU1 cards2 !inE (next_neq' x).
by rewrite (negbTE (prev_neq x)) (negbTE (prev_next_neq x)).
Qed.

(* An edge is its two darts. *)
Lemma edge_set x : porbit (twin s) x = [set x; twin s x].
Proof.
apply/setP => y; rewrite !inE; apply/porbitP/orP => [[n ->]|].
  elim: n => [|n IHn]; first by rewrite expg0 perm1; left.
  by rewrite expgSr permM; case: IHn => /eqP->; [right | left; rewrite (twinK wf)].
case=> /eqP->; first by exists 0; rewrite expg0 perm1.
by exists 1; rewrite expg1.
Qed.

Lemma card_edge x : #|porbit (twin s) x| = 2.
Proof. by rewrite edge_set cards2 twin_neq'. Qed.

End Basics.

(* Counting by orbits of one size. *)
Lemma card_porbits_uniform (D : finType) (p : {perm D}) k :
  (forall x, #|porbit p x| = k) -> #|porbits p| * k = #|D|.
Proof.
move=> size_k; have part : partition (porbits p) [set: D].
  have -> : porbits p = orbit 'P <[p]> @: [set: D].
    by apply/setP => A; apply/imsetP/imsetP => -[x _ ->]; exists x; rewrite ?porbitE ?inE.
  apply: orbit_partition; apply/subsetP => a _; rewrite !inE /=.
  by apply/subsetP => x; rewrite !inE.
rewrite -cardsT (@card_uniform_partition _ k (porbits p)) //.
by move=> A /imsetP[x _ ->].
Qed.

Section Counting.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.

Lemma edges2 : edges s * 2 = #|D|.
Proof. by apply: card_porbits_uniform => x; apply: card_edge. Qed.

Lemma faces3 : faces s * 3 = #|D|.
Proof. by apply: card_porbits_uniform => x; apply: card_face. Qed.

(* Labels name the vertices: there are as many as orbits. *)
Lemma vertices_labels : vertices s = #|V|.
Proof.
pose orbit_of v := [set x | origin s x == v].
have orbit_of_origin x : orbit_of (origin s x) = porbit (sigma s) x.
  by apply/setP => y; rewrite inE eq_sym (label_orbit wf).
have -> : vertices s = #|orbit_of @: [set: V]|.
  rewrite /vertices; congr #|pred_of_set _|; apply/setP => A; apply/imsetP/imsetP => -[].
    by move=> x _ ->; exists (origin s x); rewrite ?inE ?orbit_of_origin.
  by move=> v _ ->; have [x <-] := label_used wf v; exists x; rewrite ?orbit_of_origin.
rewrite card_imset ?cardsT // => v w eq_vw; have [x def_v] := label_used wf v.
have: x \in orbit_of w by rewrite -eq_vw inE def_v.
by rewrite inE def_v => /eqP.
Qed.

(* On a sphere the numbers of edges and faces follow from that of vertices. *)
Lemma sphere_faces : sphere s -> faces s + 4 = 2 * #|V|.
Proof.
case=> _; rewrite vertices_labels => euler_eq.
have ef : faces s * 3 = edges s * 2 by rewrite faces3 edges2.
apply/eqP; rewrite -(eqn_add2l (faces s * 2)) addnA -mulnSr ef [2 * _]mulnC -mulnDl.
by rewrite -(mulnDl _ 2 2) [_ + #|V|]addnC euler_eq.
Qed.

End Counting.

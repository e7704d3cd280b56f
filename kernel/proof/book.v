(* What a book looks like.

   In a book every face contains both hubs a and b, so that each face has one more corner: its page.
   If every page is a vertex of degree two ([narrow]; it is so on the sphere), each page p
   has two faces, one with the corners a, b, p in this order and one with b, a, p; a dart is known
   by the corners of its face ([corners_inj]); and turning about the hub a meets all the pages
   one after the other ([page_order_exists]): the pages have a cyclic order. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* The three corners of the face of a dart, beginning with its own. *)
Definition corners (D V : finType) (s : surface D V) x :=
  (origin s x, origin s (next s x), corner s x).

(* The page q follows the page p about the hubs a, b: there is an edge from a to b with the face
   a, b, p on its one side and the face b, a, q on the other. *)
Definition page_step (D V : finType) (s : surface D V) (a b p q : V) :=
  [exists x, (corners s x == (a, b, p)) && (corner s (twin s x) == q)].

(* The vertices that are not hubs, one for each page. *)
Definition page (V : finType) (a b : V) := [pred p | (p != a) && (p != b)].

(* Every page is a vertex of degree two. *)
Definition narrow (D V : finType) (s : surface D V) (a b : V) :=
  forall p, page a b p -> #|[set x | origin s x == p]| = 2.

(* The pages of a book in their cyclic order, from any of them on. *)
Definition page_order (D V : finType) (s : surface D V) (a b : V) (c : seq V) :=
  [/\ uniq c, c =i page a b & path.cycle (page_step s a b) c].

Section Corners.

Variables D V : finType.
Variable s : surface D V.
Hypothesis wf : well_formed s.
Hypothesis lf : loopless s.
Implicit Types x y : D.

Lemma corners_next x : corners s (next s x) = (origin s (next s x), corner s x, origin s x).
Proof. by rewrite /corners /corner /prev (next3 wf). Qed.

Lemma corners_prev x : corners s (prev s x) = (corner s x, origin s x, origin s (next s x)).
Proof. by rewrite corners_next /corner /prev (next3 wf). Qed.

Lemma corners_twin x :
  corners s (twin s x) = (origin s (next s x), origin s x, corner s (twin s x)).
Proof. by rewrite /corners (origin_twin wf) (origin_next_twin wf). Qed.

Lemma corners_differ x :
  [/\ origin s x != origin s (next s x), origin s (next s x) != corner s x &
      corner s x != origin s x].
Proof.
split; [exact: (lf x) | exact: (lf (next s x)) |].
by have := lf (prev s x); rewrite /corner /prev (next3 wf).
Qed.

End Corners.

Lemma corners_eq_next (D D' V : finType) (s : surface D V) (s' : surface D' V) x x' :
    well_formed s -> well_formed s' ->
  (corners s x == corners s' x') = (corners s (next s x) == corners s' (next s' x')).
Proof. by move=> wf wf'; rewrite !corners_next // !xpair_eqE -andbA andbC. Qed.

Section Pages.

Variables D V : finType.
Variable s : surface D V.
Variables a b : V.
Hypothesis wf : well_formed s.
Hypothesis lf : loopless s.
Hypothesis ab : a != b.
Hypothesis bk : book s a b.
Implicit Types x y : D.

(* The other two corners of a face at a page are the hubs. *)
Lemma page_hubs x : page a b (origin s x) ->
  origin s (next s x) = a /\ corner s x = b \/ origin s (next s x) = b /\ corner s x = a.
Proof.
rewrite inE => /andP[/negbTE xa /negbTE xb]; move: (bk.1 x) (bk.2 x) ab; rewrite /at_face xa xb /=.
by case/orP=> /eqP-> /orP[] /eqP->; rewrite ?eqxx //; [left | right].
Qed.

(* One of the three corners of a face is a page. *)
Lemma face_page x :
  [\/ page a b (origin s x), page a b (origin s (next s x)) | page a b (corner s x)].
Proof.
have [n1 n2 n3] := corners_differ wf lf x; move: (bk.1 x) (bk.2 x) ab n1 n2 n3.
rewrite /at_face !inE.
move: (origin s x) (origin s (next s x)) (corner s x) => u v w.
case/or3P=> /eqP <- /or3P[] /eqP <-; rewrite ?eqxx // => n0 n1 n2 n3.
- by constructor 3; rewrite n3 eq_sym n2.
- by constructor 2; rewrite n2 eq_sym n1.
- by constructor 3; rewrite n3 eq_sym n2.
- by constructor 1; rewrite n1 eq_sym n3.
- by constructor 2; rewrite n2 eq_sym n1.
- by constructor 1; rewrite n1 eq_sym n3.
Qed.

(* An edge that is not at a page joins the hubs. *)
Lemma hub_ends x : ~~ page a b (origin s x) -> ~~ page a b (origin s (next s x)) ->
  origin s x = a /\ origin s (next s x) = b \/ origin s x = b /\ origin s (next s x) = a.
Proof.
have [n1 _ _] := corners_differ wf lf x; move: n1; rewrite !negb_and !negbK.
by move=> n1 /orP[] /eqP e1 /orP[] /eqP e2; rewrite e1 e2 ?eqxx // in n1 *; [left | right].
Qed.

(* The faces on both sides of an edge at a page have the same third corner, a hub. *)
Lemma corner_twin x : page a b (origin s x) || page a b (origin s (next s x)) ->
  corner s (twin s x) = corner s x.
Proof.
have nab : a <> b by apply/eqP.
case/orP=> pg.
  have pg' : page a b (origin s (next s (twin s x))) by rewrite (origin_next_twin wf).
  have := page_hubs pg'; rewrite /corner /prev (next3 wf) (origin_twin wf).
  by case: (page_hubs pg); rewrite /corner /prev => -[e1 e2] [] [f1 f2]; congruence.
have pg' : page a b (origin s (twin s x)) by rewrite (origin_twin wf).
have := page_hubs pg; have := page_hubs pg'; rewrite /corner /prev (origin_next_twin wf) (next3 wf).
by case=> -[e1 e2] [] [f1 f2]; congruence.
Qed.

(* A page turns into its other face. *)
Lemma corners_sigma x : page a b (origin s x) ->
  corners s (sigma s x) = (origin s x, corner s x, origin s (next s x)).
Proof.
move=> pg; rewrite sigmaE corners_next // (origin_next_twin wf) (origin_twin wf).
by rewrite corner_twin ?pg.
Qed.

Hypothesis thin : narrow s a b.

(* Two darts start at a page: one toward each hub. *)
Lemma page_darts x y : page a b (origin s x) -> origin s y = origin s x ->
  y = x \/ y = sigma s x.
Proof.
move=> pg oyx; have : [set x; sigma s x] == [set z | origin s z == origin s x].
  rewrite eqEcard (thin pg) cards2; apply/andP; split.
    apply/subsetP => z; rewrite !inE => /orP[] /eqP-> //.
    by have [-> _] := corners_sigma pg.
  case: eqP => // e; have [_ no _] := corners_differ wf lf x.
  by have [_ eq_o _] := corners_sigma pg; rewrite -e in eq_o; rewrite eq_o eqxx in no.
move/eqP/setP/(_ y); rewrite !inE oyx eqxx => /orP[] /eqP; [by left | by right].
Qed.

(* A dart is known by the corners of its face. *)
Lemma corners_inj : injective (corners s).
Proof.
have inj_page x y : page a b (origin s x) -> corners s x = corners s y -> x = y.
  move=> pg [oxy nxy _]; case: (page_darts pg (esym oxy)) => // def_y.
  have [_ no _] := corners_differ wf lf x; have [_ eq_o _] := corners_sigma pg.
  by rewrite nxy def_y eq_o eqxx in no.
move=> x y eq_xy; case: (face_page x) => pg; first exact: inj_page pg eq_xy.
  apply: (next_inj (s := s)); apply: inj_page pg _.
  by apply/eqP; rewrite -(corners_eq_next _ _ wf wf) eq_xy.
apply: (prev_inj (s := s)); apply: inj_page pg _.
by apply/eqP; rewrite -!(corners_eq_next _ _ wf wf) eq_xy.
Qed.

(* Every page has a face of either direction. *)
Lemma page_face p : page a b p -> exists x, corners s x = (a, b, p).
Proof.
move=> pg; have [x def_p] := label_used wf p; rewrite -def_p in pg *.
case: (page_hubs pg) => -[e1 e2].
  by exists (next s x); rewrite corners_next // e1 e2.
exists (next s (sigma s x)); rewrite corners_next //.
by have [-> -> ->] := corners_sigma pg; rewrite e1 e2.
Qed.

Lemma page_face_back p : page a b p -> exists x, corners s x = (b, a, p).
Proof.
move=> pg; have [x [cx nx ox]] := page_face pg; exists (next s (sigma s (prev s x))).
have pgx : page a b (origin s (prev s x)) by rewrite -/(corner s x) ox.
have [e1 e2 e3] := corners_sigma pgx; rewrite corners_next // e1 e2 e3.
by rewrite -/(corner s x) ox prevK // cx /corner /prev (next3 wf) nx.
Qed.

(* The page after p, seen from any of the darts that show it. *)
Lemma page_stepE x p q :
  corners s x = (a, b, p) -> page_step s a b p q = (corner s (twin s x) == q).
Proof.
move=> cx; apply/existsP/idP => [[y /andP[/eqP cy]]|cq]; last by exists x; rewrite cx eqxx.
by rewrite (corners_inj (etrans cx (esym cy))).
Qed.

(* Only pages are followed by something, and by one page only. *)
Lemma page_step_page p q : page_step s a b p q -> page a b p && page a b q.
Proof.
case/existsP => x /andP[/eqP[<- <- <-] /eqP <-].
have [_ n2 n3] := corners_differ wf lf x; have [_ m2 m3] := corners_differ wf lf (twin s x).
rewrite !(origin_twin wf, origin_next_twin wf) in m2 m3.
by rewrite !inE n3 m3 [_ == origin s x]eq_sym m2 [_ == origin s (next s x)]eq_sym n2.
Qed.

Lemma page_step_fun p q q' : page_step s a b p q -> page_step s a b p q' -> q = q'.
Proof.
case/existsP => x /andP[/eqP cx /eqP <-]; rewrite (page_stepE _ cx); exact: eqP.
Qed.

(* Turning twice about the hub a leads from one page to the next. *)
Definition turn_page x := sigma s (sigma s x).

Lemma corners_sigma_hub x p :
  corners s x = (a, b, p) -> corners s (sigma s x) = (a, corner s (twin s x), b).
Proof.
move=> [ox nx _].
by rewrite sigmaE corners_next // (origin_next_twin wf) (origin_twin wf) ox nx.
Qed.

Lemma page_behind x p : corners s x = (a, b, p) -> page a b (corner s (twin s x)).
Proof.
move=> [ox nx _]; have [_ n2 n3] := corners_differ wf lf (twin s x).
rewrite !(origin_twin wf, origin_next_twin wf) ox nx in n2 n3.
by rewrite inE n3 eq_sym n2.
Qed.

Lemma corners_turn_page x p :
  corners s x = (a, b, p) -> corners s (turn_page x) = (a, b, corner s (twin s x)).
Proof.
move=> cx; have [e1 e2 e3] := corners_sigma_hub cx; have pg := page_behind cx.
rewrite /turn_page sigmaE corners_next // (origin_next_twin wf) (origin_twin wf) e1 e2.
by rewrite corner_twin ?e3 // e2 pg orbT.
Qed.

Lemma corners_iter n x p : corners s x = (a, b, p) ->
  corners s (iter n turn_page x) = (a, b, corner s (iter n turn_page x)).
Proof.
move=> cx; elim: n => [|n IHn]; first by rewrite /= cx; have [_ _ ->] := cx.
have [e1 e2 _] := corners_turn_page IHn.
by rewrite iterS /corners e1 e2.
Qed.

(* The pages of a book have a cyclic order: turning about the hub a meets them all. *)
Theorem page_order_exists : exists c, page_order s a b c.
Proof.
have [x _] := label_used wf a.
have [p pgp] : exists p, page a b p by case: (face_page x) => pg; eexists; apply: pg.
have [x0 cx0] := page_face pgp.
have turn_inj : injective turn_page by move=> y z /sigma_inj /sigma_inj.
have corners_orbit y : y \in fingraph.orbit turn_page x0 -> corners s y = (a, b, corner s y).
  by rewrite -fconnect_orbit => /iter_findex <-; apply: corners_iter cx0.
exists (map (corner s) (fingraph.orbit turn_page x0)); split.
- rewrite map_inj_in_uniq ?orbit_uniq // => y z /corners_orbit cy /corners_orbit cz eq_c.
  by apply: corners_inj; rewrite cy cz eq_c.
- move=> q; apply/mapP/idP => [[y /corners_orbit cy ->]|pgq].
    have [ny1 ny2 ny3] := corners_differ wf lf y; have [e1 e2] := cy.
    by rewrite e1 e2 in ny2 ny3; rewrite inE /= ny3 eq_sym ny2.
  have [y cy] := page_face pgq; exists y; last by have [_ _ ->] := cy.
  have [oy ny _] := cy; have [o0 _ _] := cx0.
  have : y \in porbit (sigma s) x0 by rewrite -(label_orbit wf) oy o0.
  case/porbitP => n def_y; rewrite -fconnect_orbit.
  have iter_sigma m : iter m turn_page x0 = (sigma s ^+ m.*2)%g x0.
    elim: m => [|m IHm]; first by rewrite expg0 perm1.
    by rewrite iterS IHm doubleS expgSr permM expgSr permM.
  rewrite -(odd_double_half n) addnC expgD permM -iter_sigma in def_y.
  case: (odd n) def_y => def_y; last by rewrite def_y expg0 perm1 fconnect_iter.
  have cz := corners_iter n./2 cx0; have := page_behind cz; rewrite expg1 in def_y.
  by have [_ <- _] := corners_sigma_hub cz; rewrite -def_y ny inE eqxx andbF.
- rewrite cycle_map; apply: (sub_in_cycle (P := mem (fingraph.orbit turn_page x0))
                                     (e := frel turn_page)).
  + move=> y z /corners_orbit cy _ /= /eqP <-; apply/existsP; exists y.
    by rewrite cy eqxx /=; have [_ _ ->] := corners_turn_page cy.
  + exact/allP.
  + exact: cycle_orbit.
Qed.

End Pages.

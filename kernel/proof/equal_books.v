(* Two books with the same hubs and the same cyclic order of pages are the same labelled surface. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach book.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Surfaces whose darts are known by the corners of their faces are the same as soon as the same
   faces occur in both and lie beside each other in the same way. *)
Lemma same_by_corners (D D' V : finType) (s : surface D V) (s' : surface D' V) :
    well_formed s -> well_formed s' ->
    injective (corners s) -> injective (corners s') ->
    (forall x, exists x', corners s' x' == corners s x) ->
    (forall x', exists x, corners s x == corners s' x') ->
    (forall x x', corners s' x' = corners s x -> corner s' (twin s' x') = corner s (twin s x)) ->
  same_surface s s'.
Proof.
move=> wf wf' inj inj' onto onto' beside.
pose f x := xchoose (onto x); pose g x' := xchoose (onto' x').
have cf x : corners s' (f x) = corners s x by apply/eqP/(xchooseP (onto x)).
have cg x' : corners s (g x') = corners s' x' by apply/eqP/(xchooseP (onto' x')).
exists f; split=> [|x|x|x].
- by exists g => [x|x']; [apply: inj; rewrite cg cf | apply: inj'; rewrite cf cg].
- apply: inj'; rewrite cf !corners_twin // (beside _ _ (cf x)).
  by have [-> -> _] := cf x.
- by apply: inj'; rewrite cf !corners_next //; have [-> -> ->] := cf x.
- by have [] := cf x.
Qed.

Section EqualBooks.

Variables D D' V : finType.
Variables (s : surface D V) (s' : surface D' V) (a b : V).
Hypotheses (wf : well_formed s) (wf' : well_formed s').
Hypotheses (lf : loopless s) (lf' : loopless s').
Hypothesis ab : a != b.
Hypotheses (bk : book s a b) (bk' : book s' a b).
Hypotheses (thin : narrow s a b) (thin' : narrow s' a b).

(* The faces of a book are known from its hubs and pages. *)
Lemma same_faces x : exists x', corners s' x' == corners s x.
Proof.
have from_page z : page a b (origin s z) -> exists z', corners s' z' = corners s z.
  move=> pg; case: (page_hubs ab bk pg) => -[e1 e2].
    have [y cy] := page_face wf' ab bk' pg.
    exists (prev s' y); rewrite corners_prev //.
    by move: cy; rewrite /corners e1 e2 => -[-> -> ->].
  have [y cy] := page_face_back wf' ab bk' pg.
  exists (prev s' y); rewrite corners_prev //.
  by move: cy; rewrite /corners e1 e2 => -[-> -> ->].
case: (face_page wf lf ab bk x) => pg.
- by have [x' cx'] := from_page x pg; exists x'; rewrite cx'.
- have [y cy] := from_page (next s x) pg; exists (prev s' y).
  by rewrite (corners_eq_next _ _ wf' wf) prevK // cy.
have [y cy] := from_page (prev s x) pg; exists (next s' y).
by rewrite -{1}(prevK wf x) -(corners_eq_next _ _ wf' wf) cy.
Qed.


Hypothesis same_order : forall p q, page_step s a b p q = page_step s' a b p q.

(* They lie beside each other as the cyclic order says. *)
Lemma same_beside x x' :
  corners s' x' = corners s x -> corner s' (twin s' x') = corner s (twin s x).
Proof.
move=> cx; have [ox nx _] := cx.
case pg: (page a b (origin s x) || page a b (origin s (next s x))).
  rewrite (corner_twin wf ab bk pg); rewrite -ox -nx in pg.
  by rewrite (corner_twin wf' ab bk' pg); have [_ _ ->] := cx.
move/negbT: pg; rewrite negb_or => /andP[pg0 pg1].
case: (hub_ends wf lf pg0 pg1) => -[e1 e2].
- apply/eqP; rewrite -(page_stepE wf' lf' ab bk' thin' (x := x') (p := corner s x)).
    by rewrite -same_order (page_stepE wf lf ab bk thin (x := x)) // /corners e1 e2.
  by rewrite cx /corners e1 e2.
have cy : corners s (twin s x) = (a, b, corner s (twin s x)) by rewrite corners_twin // e1 e2.
have : page_step s a b (corner s (twin s x)) (corner s x).
  by rewrite (page_stepE wf lf ab bk thin _ cy) (twinK wf).
rewrite same_order => /existsP[y' /andP[/eqP cy' /eqP cty']].
have -> : x' = twin s' y'.
  apply: (corners_inj wf' lf' ab bk' thin'); have [oy ny _] := cy'.
  by rewrite cx corners_twin // cty' oy ny /corners e1 e2.
by rewrite (twinK wf'); have [_ _ ->] := cy'.
Qed.

End EqualBooks.

(* Two books with the same hubs, in which each page is followed by the same page, are equal. *)
Theorem equal_books (D D' V : finType) (s : surface D V) (s' : surface D' V) (a b : V) :
    well_formed s -> well_formed s' -> loopless s -> loopless s' -> a != b ->
    book s a b -> book s' a b -> narrow s a b -> narrow s' a b ->
    page_step s a b =2 page_step s' a b ->
  same_surface s s'.
Proof.
move=> wf wf' lf lf' ab bk bk' thin thin' same_order; apply: same_by_corners => //.
- exact: corners_inj thin.
- exact: corners_inj thin'.
- exact: same_faces wf wf' lf ab bk bk'.
- exact: same_faces wf' wf lf' ab bk' bk.
- exact: same_beside wf wf' lf lf' ab bk bk' thin thin' same_order.
Qed.

(* In particular when their pages have the same cyclic order. *)
Theorem equal_books_order (D D' V : finType) (s : surface D V) (s' : surface D' V) (a b : V) c :
    well_formed s -> well_formed s' -> loopless s -> loopless s' -> a != b ->
    book s a b -> book s' a b -> narrow s a b -> narrow s' a b ->
    page_order s a b c -> page_order s' a b c ->
  same_surface s s'.
Proof.
move=> wf wf' lf lf' ab bk bk' thin thin' [_ cV cyc] [_ _ cyc'].
apply: (equal_books wf wf' lf lf' ab bk bk' thin thin') => p q; apply/idP/idP => step.
  have pc : p \in c by rewrite cV; case/andP: (page_step_page wf lf step).
  by rewrite (page_step_fun wf lf ab bk thin step (next_cycle cyc pc)) next_cycle.
have pc : p \in c by rewrite cV; case/andP: (page_step_page wf' lf' step).
by rewrite (page_step_fun wf' lf' ab bk' thin' step (next_cycle cyc' pc)) next_cycle.
Qed.

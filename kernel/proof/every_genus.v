(* For every genus from 2 on there are two labelled surfaces with three vertices that flips do not
   join: Theorem 4.3 does not extend to them.

   Take 2 g + 1 faces with the corners 0, 1, 2 in this order and as many with the corners in the
   other order, both numbered by remainders, and glue them so that turning about the corner k of
   the face x by two faces leads to the face x + d k ([cyclic_surface]).  Where the sum of the
   three d k is 0 the faces close up, and where each d k generates all remainders there are three
   vertices: a surface of genus g.  We take -2, 1, 1 and 1, 1, -2.  In the first, turning about
   the corner 1 and then going on to the corner 2 leads where going on and then turning leads; in
   the second the two are 3 faces apart, and 3 is not 0.  So the two are different, and since no
   flip is allowed where there are three vertices, flips do not join them
   ([higher_genus_not_joined]). *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg zmodp.
From Tightflip Require Import surface flip invariants reach connected higher_genus.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.

(* The three vertices 0, 1 and 2, called None, Some false and Some true, and the order in which half
   of the faces have them. *)
Definition corner3 := [finType of option bool].
Definition after (k : corner3) : corner3 :=
  match k with None => Some false | Some false => Some true | Some true => None end.
Definition before (k : corner3) : corner3 :=
  match k with None => Some true | Some false => None | Some true => Some false end.

Lemma afterK : cancel after before. Proof. by case=> [[]|]. Qed.
Lemma beforeK : cancel before after. Proof. by case=> [[]|]. Qed.

Section Cyclic.

Variable n : nat.
Variable d : corner3 -> 'I_n.+1.
Hypothesis sum_d : (d None + d (Some false) + d (Some true) = 0)%R.
Hypothesis gen_d : forall k y, exists m, y = (d k *+ m)%R.

(* The dart (k, false, x) starts at the corner k of the face x; (k, true, x) is its twin, a side of
   one of the other faces. *)
Definition cdart := [finType of corner3 * bool * 'I_n.+1].
Implicit Types (z : cdart) (k : corner3) (x : 'I_n.+1).

Let tw z : cdart := let: (k, b, x) := z in (k, ~~ b, x).
Let nx z : cdart :=
  let: (k, b, x) := z in if b then (before k, true, x + d k)%R else (after k, false, x).
Let og z : corner3 := let: (k, b, x) := z in if b then after k else k.

Lemma cyclic_twin_inj : injective tw.
Proof. by apply: inv_inj => -[[k b] x]; rewrite /tw negbK. Qed.

Lemma cyclic_next3 z : nx (nx (nx z)) = z.
Proof.
case: z => [[k [] ] x] /=; last by case: k => [[]|].
rewrite -!addrA; have -> : (d k + (d (before k) + d (before (before k))) = 0)%R.
  rewrite -sum_d; case: k => [[]|] /=.
  - by rewrite addrC [(d _ + d None)%R]addrC.
  - by rewrite addrCA addrA.
  - by rewrite addrA addrAC.
by rewrite addr0; case: k => [[]|].
Qed.

Lemma cyclic_next_inj : injective nx.
Proof. exact: (can_inj (g := fun z => nx (nx z))) cyclic_next3. Qed.

Definition cyclic_surface : surface cdart corner3 :=
  Surface (perm cyclic_twin_inj) (perm cyclic_next_inj) [ffun z => og z].

Let s := cyclic_surface.

Lemma cyclic_twinE k b x : twin s (k, b, x) = (k, ~~ b, x). Proof. by rewrite permE. Qed.
Lemma cyclic_nextE k b x :
  next s (k, b, x) = if b then (before k, true, x + d k)%R else (after k, false, x).
Proof. by rewrite permE. Qed.
Lemma cyclic_originE k b x : origin s (k, b, x) = if b then after k else k.
Proof. by rewrite ffunE. Qed.

Lemma cyclic_turn k x : sigma s (sigma s (k, false, x)) = (k, false, x + d k)%R.
Proof. by rewrite !sigmaE !(cyclic_twinE, cyclic_nextE) /= beforeK. Qed.

Lemma cyclic_sigma2 k x m : (sigma s ^+ m.*2)%g (k, false, x) = (k, false, x + d k *+ m)%R.
Proof.
elim: m x => [|m IHm] x; first by rewrite expg0 perm1 mulr0n addr0.
by rewrite doubleS 2!expgS 2!permM cyclic_turn IHm mulrS addrA.
Qed.

(* All darts that start at the vertex k. *)
Lemma cyclic_orbit k z : (origin s z == k) = (z \in porbit (sigma s) (k, false, 0%R)).
Proof.
have sigma_to k' x : sigma s (k', true, x) = (after k', false, x).
  by rewrite sigmaE cyclic_twinE cyclic_nextE.
apply/eqP/porbitP => [|[m ->]].
  case: z => [[k' b] x]; rewrite cyclic_originE; case: b => [<-|->].
    have [m def_x] := gen_d (after k') (x - d (after k'))%R; exists m.*2.+1.
    rewrite expgSr permM cyclic_sigma2 sigmaE cyclic_twinE cyclic_nextE /= afterK.
    by rewrite add0r -def_x subrK.
  by have [m ->] := gen_d k x; exists m.*2; rewrite cyclic_sigma2 add0r.
elim: m => [|m IHm]; first by rewrite expg0 perm1 cyclic_originE.
rewrite expgSr permM -[RHS]IHm; case: (_ (k, false, 0%R)) => [[k' []] x].
  by rewrite sigma_to !cyclic_originE.
by rewrite sigmaE cyclic_twinE cyclic_nextE !cyclic_originE /= beforeK.
Qed.

Lemma cyclic_well_formed : well_formed s.
Proof.
split=> [z|z|z|z|z z'|k].
- by case: z => [[k b] x]; rewrite !cyclic_twinE negbK.
- by case: z => [[k b] x]; rewrite cyclic_twinE !xpair_eqE; case: b; rewrite andbF.
- by rewrite !permE cyclic_next3.
- case: z => [[k b] x]; rewrite cyclic_nextE; case: b; rewrite !xpair_eqE;
    by case: k => [[]|].
- rewrite eq_sym cyclic_orbit; have := cyclic_orbit (origin s z) z; rewrite eqxx => /esym.
  by rewrite -!eq_porbit_mem => /eqP->.
by exists (k, false, 0%R); rewrite cyclic_originE.
Qed.

Lemma cyclic_loopless : loopless s.
Proof.
case=> [[k b] x]; rewrite cyclic_nextE; case: b; rewrite !cyclic_originE;
  by case: k => [[]|].
Qed.

Lemma cyclic_connected : connected s.
Proof.
have wf := cyclic_well_formed.
have go_twin z : connect (link s) z (twin s z) by apply: connect1; rewrite /link eqxx.
have go_next z : connect (link s) z (next s z) by apply: connect1; rewrite /link eqxx orbT.
have back (x y : cdart) : connect (link s) x y -> connect (link s) y x.
  case/connectP => p; elim: p x => [|w p IHp] x /=; first by move=> _ ->.
  case/andP => xw path_p last_p; apply: connect_trans (IHp _ path_p last_p) _.
  case/orP: xw => /eqP->; first by rewrite -{2}(twinK wf x).
  by rewrite -{2}(next3 wf x); apply: connect_trans (go_next _) (go_next _).
have from_start z : connect (link s) (None, false, 0%R) z.
  have go_sigma m w : connect (link s) w ((sigma s ^+ m)%g w).
    elim: m => [|m IHm]; first by rewrite expg0 perm1 connect0.
    rewrite expgSr permM sigmaE; apply: connect_trans IHm _.
    exact: connect_trans (go_twin _) (go_next _).
  have first_vertex x : connect (link s) (None, false, 0%R) (None, false, x).
    by have [m ->] := gen_d None x; have := go_sigma m.*2 (None, false, 0%R);
      rewrite cyclic_sigma2 add0r.
  have second_vertex x : connect (link s) (None, false, 0%R) (Some false, false, x).
    by have := go_next (None, false, x); rewrite cyclic_nextE; apply: connect_trans.
  have third_vertex x : connect (link s) (None, false, 0%R) (Some true, false, x).
    by have := go_next (Some false, false, x); rewrite cyclic_nextE; apply: connect_trans.
  have positive k x : connect (link s) (None, false, 0%R) (k, false, x) by case: k => [[]|].
  case: z => [[k []] x] //; have := go_twin (k, false, x); rewrite cyclic_twinE.
  exact: connect_trans.
move=> x y; exact: connect_trans (back _ _ (from_start x)) (from_start y).
Qed.

Lemma cyclic_genus g : n = 2 * g -> has_genus s g.
Proof.
move=> def_n; have wf := cyclic_well_formed; split; first exact: cyclic_connected.
have card_D : #|cdart| = 6 * (2 * g).+1.
  by rewrite !card_prod card_option !card_bool card_ord def_n.
have -> : edges s = 3 * (2 * g).+1.
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 2)) edges2 // card_D mulnAC.
have -> : faces s = 2 * (2 * g).+1.
  by apply/eqP; rewrite -(eqn_pmul2r (isT : 0 < 3)) faces3 // card_D mulnAC.
by rewrite vertices_labels // card_option card_bool; ring.
Qed.

End Cyclic.

Section EveryGenus.

Variable g : nat.
Hypothesis g2 : 1 < g.

Let one : 'I_(2 * g).+1 := inZp 1.
Let first (k : corner3) : 'I_(2 * g).+1 := (if k is None then - (one *+ 2) else one)%R.
Let second (k : corner3) : 'I_(2 * g).+1 := (if k is Some true then - (one *+ 2) else one)%R.

Let multiple m : (one *+ m)%R = inZp m.
Proof. by rewrite Zp_mulrn; apply: val_inj; rewrite /= modnMml mul1n. Qed.

Let gen_one y : exists m, y = (one *+ m)%R.
Proof. by exists y; rewrite multiple valZpK. Qed.

Let gen_two y : exists m, y = (- (one *+ 2) *+ m)%R.
Proof.
have all_one : (one *+ (2 * g) = - one)%R.
  apply/eqP; rewrite -subr_eq0 opprK -mulrSr multiple.
  by apply/eqP/val_inj; rewrite /= modnn.
exists (g * y); rewrite mulNrn -mulrnA mulnA mulrnA all_one mulNrn opprK multiple.
by rewrite valZpK.
Qed.

Let sum_first : (first None + first (Some false) + first (Some true) = 0)%R.
Proof. by rewrite /first -addrA -mulr2n addNr. Qed.
Let sum_second : (second None + second (Some false) + second (Some true) = 0)%R.
Proof. by rewrite /second -mulr2n addrN. Qed.

Let gen_first k y : exists m, y = (first k *+ m)%R.
Proof. by case: k => [k|]; [exact: gen_one|exact: gen_two]. Qed.
Let gen_second k y : exists m, y = (second k *+ m)%R.
Proof. by case: k => [[]|]; [exact: gen_two|exact: gen_one|exact: gen_one]. Qed.

Let s := cyclic_surface sum_first.
Let s' := cyclic_surface sum_second.

(* From x at corner 1, turning by two faces and then going on, or the other way round. *)
Let turn_go D V (r : surface D V) x := next r (sigma r (sigma r x)).
Let go_turn D V (r : surface D V) x := sigma r (sigma r (next r x)).

Let three_not_0 : (one *+ 3 != 0)%R.
Proof.
by rewrite multiple -val_eqE /= modn_small // ltnS -[3]/(2 * 1).+1 ltn_mul2l.
Qed.

Lemma cyclic_different : ~ same_surface s s'.
Proof.
case=> f [_ f_twin f_next f_origin].
pose x : cdart (2 * g) := (Some false, false, 0%R).
have together : turn_go s x = go_turn s x.
  by rewrite /turn_go /go_turn cyclic_turn !cyclic_nextE cyclic_turn.
have fx1 := f_origin x; have := f_origin (next s x).
rewrite f_next cyclic_nextE cyclic_originE => fx2.
have apart_ : turn_go s' (f x) != go_turn s' (f x).
  move: fx1 fx2; case: (f x) => [[k b] y]; rewrite cyclic_nextE; case: b; rewrite !cyclic_originE.
    by case: k => [[]|].
  move=> -> _; rewrite /turn_go /go_turn cyclic_turn !cyclic_nextE cyclic_turn.
  rewrite !xpair_eqE /= (inj_eq (addrI y)) -subr_eq0 opprK -mulrS.
  exact: three_not_0.
have f_sigma z : f (sigma s z) = sigma s' (f z) by rewrite !sigmaE f_next f_twin.
case/eqP: apart_; have := congr1 f together.
by rewrite /turn_go /go_turn f_next !f_sigma f_next.
Qed.

(* For every g > 1: two labelled surfaces of genus g with three vertices, connected and without
   loops, which flips do not join, whatever the darts are called. *)
Theorem higher_genus_not_joined : exists (D V : finType) (s s' : surface D V),
  [/\ #|V| = 3, good s /\ has_genus s g, good s' /\ has_genus s' g & ~ joined s s'].
Proof.
exists (cdart (2 * g)), corner3, s, s'.
have card3 : #|corner3| = 3 by rewrite card_option card_bool.
have good_of d (sum_d : (d None + d (Some false) + d (Some true) = 0)%R) :
    (forall k y, exists m, y = (d k *+ m)%R) -> good (@cyclic_surface (2 * g) d sum_d).
  split; [exact: cyclic_well_formed|exact: cyclic_loopless|exact: cyclic_connected].
have [wf loopl _] : good s by apply: good_of gen_first.
split=> //.
- by split; [exact: good_of gen_first|exact: (cyclic_genus sum_first gen_first (erefl _))].
- by split; [exact: good_of gen_second|exact: (cyclic_genus sum_second gen_second (erefl _))].
case=> m [u r]; have reach_u : reach s u by exists m.
by rewrite (three_vertices_alone card3 wf loopl reach_u); apply: cyclic_different.
Qed.

End EveryGenus.

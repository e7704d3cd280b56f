(* Surfaces whose darts and vertices are numbers, from tables.

   Dart i has the twin i + 1 or i - 1, whichever belongs to its pair ([mate]); nx and og are the
   next dart and the origin of each dart.  The darts are 0 to n, the vertices 0 to m.  What every
   such table must fulfil is found by calculation ([numbered_ok]); what is asked about the turning
   about a vertex is left to those who use this. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition mate i := if odd i then i.-1 else i.+1.

Lemma mateK : involutive mate.
Proof.
move=> k; rewrite /mate; case odd_k: (odd k); last by rewrite /= odd_k.
by case: k odd_k => //= k /negbTE->.
Qed.

Lemma mate_neq k : mate k != k.
Proof.
rewrite /mate; case: ifP => [|_]; last by rewrite neq_ltn ltnSn orbT.
by case: k => // k _; rewrite neq_ltn ltnSn.
Qed.

(* Going from dart to dart: true leads to the next one, false to the twin. *)
Fixpoint walk (D V : finType) (s : surface D V) (w : seq bool) x :=
  if w is c :: w' then walk s w' (if c then next s x else twin s x) else x.

Section Numbered.

Variables (n m : nat) (nx og : nat -> nat).

Fixpoint walk_numbers (w : seq bool) k :=
  if w is c :: w' then walk_numbers w' (if c then nx k else mate k) else k.

(* All darts that are reached from some in k rounds. *)
Fixpoint reached k (xs : seq nat) :=
  if k is k'.+1 then reached k' (undup (xs ++ map mate xs ++ map nx xs)) else xs.

(* Everything is in order; all darts are reached in so many rounds. *)
Definition numbered_ok rounds :=
  let darts := iota 0 n.+1 in
  [&& all (fun i => [&& mate i <= n, nx i <= n & og i <= m]) darts,
      all (fun i => [&& nx (nx (nx i)) == i, nx i != i & og i != og (nx i)]) darts,
      all (fun v => has (fun i => og i == v) darts) (iota 0 m.+1) &
      all (fun i => let xs := reached rounds [:: i] in all (mem xs) darts) darts].

Variable rounds : nat.
Hypothesis ok : numbered_ok rounds.

Implicit Types i j : 'I_n.+1.

Lemma dart_number i : val i \in iota 0 n.+1. Proof. by rewrite mem_iota ltn_ord. Qed.

Let in_range i : [/\ mate i <= n, nx i <= n & og i <= m].
Proof. by have [/allP/(_ _ (dart_number i))/and3P] := and4P ok. Qed.

Let entry_ok i : [/\ nx (nx (nx i)) = i, nx i != i & og i != og (nx i)].
Proof. by have [_ /allP/(_ _ (dart_number i))/and3P[/eqP]] := and4P ok. Qed.

Let twin_of i : 'I_n.+1 := inord (mate i).
Let next_of i : 'I_n.+1 := inord (nx i).

Let twin_ofE i : val (twin_of i) = mate i.
Proof. by have [? _ _] := in_range i; rewrite /= inordK. Qed.
Let next_ofE i : val (next_of i) = nx i.
Proof. by have [_ ? _] := in_range i; rewrite /= inordK. Qed.

Let twin_of_inj : injective twin_of.
Proof. by apply: (can_inj (g := twin_of)) => i; apply: val_inj; rewrite !twin_ofE mateK. Qed.
Let next_of_inj : injective next_of.
Proof.
apply: (can_inj (g := fun i => next_of (next_of i))) => i; apply: val_inj.
by rewrite !next_ofE; have [-> _ _] := entry_ok i.
Qed.

Definition numbered : surface [finType of 'I_n.+1] [finType of 'I_m.+1] :=
  Surface (perm twin_of_inj) (perm next_of_inj) [ffun i : 'I_n.+1 => inord (og i)].

Let s := numbered.

Lemma numbered_twin i : val (twin s i) = mate i. Proof. by rewrite permE twin_ofE. Qed.
Lemma numbered_next i : val (next s i) = nx i. Proof. by rewrite permE next_ofE. Qed.
Lemma numbered_origin i : val (origin s i) = og i.
Proof. by have [_ _ ?] := in_range i; rewrite ffunE /= inordK. Qed.

Lemma numbered_walk w i : val (walk s w i) = walk_numbers w i.
Proof.
by elim: w i => //= c w IHw i; rewrite IHw; case: c; rewrite ?numbered_next ?numbered_twin.
Qed.

Lemma numbered_twinK : involutive (twin s).
Proof. by move=> i; apply: val_inj; rewrite !numbered_twin mateK. Qed.

Lemma numbered_twin_neq i : twin s i != i.
Proof. by rewrite -val_eqE numbered_twin mate_neq. Qed.

Lemma numbered_next3 i : next s (next s (next s i)) = i.
Proof. by apply: val_inj; rewrite !numbered_next; have [-> _ _] := entry_ok i. Qed.

Lemma numbered_next_neq i : next s i != i.
Proof. by rewrite -val_eqE numbered_next; have [_ -> _] := entry_ok i. Qed.

Lemma numbered_used v : exists i, origin s i = v.
Proof.
have [_ _ /allP/(_ (val v)) used _] := and4P ok.
move: used; rewrite mem_iota ltn_ord => /(_ isT) /hasP[k].
rewrite mem_iota => /andP[_ le_kn] /eqP def_v; exists (Ordinal le_kn).
by apply: val_inj; rewrite numbered_origin.
Qed.

Lemma numbered_loopless : loopless s.
Proof.
by move=> i; rewrite -val_eqE !numbered_origin numbered_next; have [_ _ ->] := entry_ok i.
Qed.

Lemma numbered_connected : connected s.
Proof.
move=> i j; have [_ _ _ /allP/(_ _ (dart_number i))/allP/(_ _ (dart_number j))] := and4P ok.
have: forall k, k \in [:: val i] -> exists2 x, val x = k & connect (link s) i x.
  by move=> k; rewrite inE => /eqP->; exists i.
elim: rounds [:: val i] => [|r IHr] xs conn /=.
  by move/conn => [x /val_inj-> ].
apply: IHr => k; rewrite mem_undup !mem_cat => /or3P[/conn //| | ] /mapP[l /conn[x <- ix] ->].
  exists (twin s x); first exact: numbered_twin.
  by apply: connect_trans ix (connect1 _); rewrite /link eqxx.
exists (next s x); first exact: numbered_next.
by apply: connect_trans ix (connect1 _); rewrite /link eqxx orbT.
Qed.

End Numbered.

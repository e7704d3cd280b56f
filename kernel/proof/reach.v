(* Being joined by flips, step by step, with the number of flips; and the words hub and book.

   [reach_in s n s']: n allowed flips, one after the other, lead from s to s'.  Flips keep the set
   of darts, so both surfaces have the same.  [good s]: s is well-formed, free of loops and
   connected; flips keep that.  [hub s v]: every face contains the vertex v.  [book s a b]: every
   face contains both a and b, the hubs of the book. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Reach.

Variables D V : finType.
Implicit Types s : surface D V.

Inductive reach_in s : nat -> surface D V -> Prop :=
| reach_in0 : reach_in s 0 s
| reach_inS h n s' : allowed s h -> reach_in (flip h s) n s' -> reach_in s n.+1 s'.

Definition reach s s' := exists n, reach_in s n s'.

Record good s : Prop := Good {
  good_wf : well_formed s;
  good_loopless : loopless s;
  good_connected : connected s }.

(* v is a corner of the face of x. *)
Definition at_face s v x := [|| origin s x == v, origin s (next s x) == v | corner s x == v].
Definition hub s v := forall x, at_face s v x.
Definition book s a b := hub s a /\ hub s b.

Lemma reach_in1 s h : allowed s h -> reach_in s 1 (flip h s).
Proof. by move=> ok; apply: reach_inS ok _; apply: reach_in0. Qed.

Lemma reach_in_trans s1 s2 s3 n m : reach_in s1 n s2 -> reach_in s2 m s3 -> reach_in s1 (n + m) s3.
Proof.
by move=> r12 r23; elim: r12 r23 => // s h k s' ok _ IH r; apply: reach_inS ok (IH r).
Qed.

Lemma reach_refl s : reach s s.
Proof. by exists 0; apply: reach_in0. Qed.

Lemma reach_trans s1 s2 s3 : reach s1 s2 -> reach s2 s3 -> reach s1 s3.
Proof. by move=> [n r12] [m r23]; exists (n + m); apply: reach_in_trans r23. Qed.

Lemma reach_flip h s : allowed s h -> reach s (flip h s).
Proof. by move=> ok; exists 1; apply: reach_in1. Qed.

(* What a flip keeps, any number of flips keeps. *)
Lemma flip_good s h : good s -> allowed s h -> good (flip h s).
Proof.
case=> wf lf con al; have ap := allowed_apart wf al; split.
- exact: flip_well_formed.
- by apply/flip_loopless.
- exact: flip_connected.
Qed.

Lemma good_flip_sphere s h : good s -> allowed s h -> sphere s -> sphere (flip h s).
Proof. by case=> wf _ _ al; apply: flip_sphere (allowed_apart wf al). Qed.

Lemma reach_in_good s n s' : reach_in s n s' -> good s -> good s'.
Proof. by elim=> {s n s'} // s h n s' al _ IH gd; apply: IH; apply: flip_good. Qed.

Lemma reach_in_sphere s n s' : reach_in s n s' -> good s -> sphere s -> sphere s'.
Proof.
elim=> {s n s'} // s h n s' al _ IH gd sph.
by apply: IH; [apply: flip_good | apply: good_flip_sphere].
Qed.

End Reach.

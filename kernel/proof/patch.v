(* Flips within a patch of faces, by computation.

   A patch is a set of whole faces whose darts are given by a table: dart number i is [f i], for i
   below n, its next dart is number nx_i, its origin the label number og_i, and its twin number
   tw_i, where that is below n; a twin outside the patch (or not looked at) has the number n.
   Flips of edges inside the patch turn the table by a computation and leave everything outside
   as it was.  So what some flips do to a patch can be found by running them on numbers. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip reach.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* A table: the numbers of the next darts, and the numbers of the labels. *)
Definition table := (seq nat * seq nat)%type.

Section Tables.

Variables (n m : nat) (tw : seq nat).
Implicit Types T : table.

Definition tnext T i := nth 0 T.1 i.
Definition tlabel T i := nth 0 T.2 i.
Definition tcorner T i := tlabel T (tnext T (tnext T i)).

(* The flip of the edge of dart i, on the table. *)
Definition flip_table i T : table :=
  let t := nth n tw i in
  let i1 := tnext T i in let b := tnext T i1 in
  let t1 := tnext T t in let d := tnext T t1 in
  (mkseq (fun k => if k == i then b else if k == b then t1 else if k == t1 then i else
                   if k == t then d else if k == d then i1 else if k == i1 then t else
                   tnext T k) n,
   mkseq (fun k => if k == i then tlabel T d else if k == t then tlabel T b else tlabel T k) n).

(* The numbers stay within the table. *)
Definition table_ok T := all (fun k => k < n) T.1 && (size T.1 == n).

(* The flip is allowed where the corners opposite the edge have different numbers (below m, where
   different numbers are different labels). *)
Definition flip_table_ok i T :=
  [&& i < n, nth n tw i < n, tcorner T i < m, tcorner T (nth n tw i) < m &
      tcorner T i != tcorner T (nth n tw i)].

Fixpoint run p T := if p is i :: p' then run p' (flip_table i T) else T.
Fixpoint run_ok p T :=
  table_ok T && (if p is i :: p' then flip_table_ok i T && run_ok p' (flip_table i T) else true).

End Tables.

(* The darts of a patch are different where their faces have different labels. *)
Definition table_faces n T := mkseq (fun i => (tlabel T i, tlabel T (tnext T i), tcorner T i)) n.

Section Patch.

Variables D V : finType.
Variables (n m : nat) (tw : seq nat) (f : nat -> D) (l : nat -> V).
Hypothesis l_inj : forall i j, i < m -> j < m -> l i = l j -> i = j.
Implicit Types (s : surface D V) (T : table).

Definition patch s T := forall i, i < n ->
  [/\ next s (f i) = f (tnext T i), origin s (f i) = l (tlabel T i) &
      nth n tw i < n -> twin s (f i) = f (nth n tw i)].

Definition outside x := forall i, i < n -> x != f i.

Lemma tnext_lt T i : table_ok n T -> i < n -> tnext T i < n.
Proof. by case/andP=> /allP all_lt /eqP sz lt_in; apply: all_lt; rewrite mem_nth ?sz. Qed.

Lemma patch_outside_next s T x : well_formed s -> table_ok n T -> patch s T ->
  outside x -> outside (next s x).
Proof.
move=> wf ok pa out i lt_in; apply/eqP => nx; have lt2 := tnext_lt ok (tnext_lt ok lt_in).
have [e1 _ _] := pa i lt_in; have [e2 _ _] := pa _ (tnext_lt ok lt_in).
by case/eqP: (out _ lt2); rewrite -e2 -e1 -nx (next3 wf).
Qed.

Lemma outsideP x : (exists2 i, i < n & x = f i) \/ outside x.
Proof.
case: (boolP [exists i : 'I_n, x == f i]) => [/existsP[i /eqP->]|no]; first by left; exists i.
by right=> i lt_in; apply: contra no => /eqP->; apply/existsP; exists (Ordinal lt_in).
Qed.

Lemma patch_corner s T i : table_ok n T -> patch s T -> i < n -> corner s (f i) = l (tcorner T i).
Proof.
move=> ok pa lt_in; have [e1 _ _] := pa i lt_in.
have [e2 _ _] := pa _ (tnext_lt ok lt_in); have lt2 := tnext_lt ok (tnext_lt ok lt_in).
by have [_ e3 _] := pa _ lt2; rewrite /corner /prev e1 e2 e3.
Qed.

(* Darts of a patch are different where the labels of their faces are. *)
Lemma patch_inj s T : table_ok n T -> all (fun k => k < m) T.2 -> size T.2 = n ->
    uniq (table_faces n T) -> patch s T ->
  forall i j, i < n -> j < n -> f i = f j -> i = j.
Proof.
move=> ok /allP lab_lt sz un pa i j lt_in lt_jn eq_ij.
have lt_lab k : k < n -> tlabel T k < m by move=> lt_kn; apply: lab_lt; rewrite mem_nth ?sz.
have [e1 e2 _] := pa i lt_in; have [e1' e2' _] := pa j lt_jn.
have [_ e3 _] := pa _ (tnext_lt ok lt_in); have [_ e3' _] := pa _ (tnext_lt ok lt_jn).
apply/eqP; rewrite -(nth_uniq (0, 0, 0) _ _ un) ?size_mkseq // !nth_mkseq //.
have -> : tlabel T i = tlabel T j by apply: l_inj; rewrite ?lt_lab // -e2 -e2' eq_ij.
have -> : tlabel T (tnext T i) = tlabel T (tnext T j).
  by apply: l_inj; rewrite ?lt_lab ?tnext_lt // -e3 -e3' -e1 -e1' eq_ij.
have -> // : tcorner T i = tcorner T j.
by apply: l_inj; rewrite ?lt_lab ?tnext_lt // -!(patch_corner ok pa) ?eq_ij.
Qed.

Hypothesis f_inj : forall i j, i < n -> j < n -> f i = f j -> i = j.

Lemma f_eq i j : i < n -> j < n -> (f i == f j) = (i == j).
Proof. by move=> lt_in lt_jn; apply/eqP/eqP => [/f_inj|->] //; apply. Qed.

Lemma patch_flip s T i : well_formed s -> apart s (f i) -> table_ok n T ->
    i < n -> nth n tw i < n ->
  patch s T -> patch (flip (f i) s) (flip_table n tw i T).
Proof.
move=> wf ap ok lt_in lt_tn pa k lt_kn.
have step j : j < n -> next s (f j) = f (tnext T j) by move=> lt_jn; have [] := pa j lt_jn.
have lt_next j : j < n -> tnext T j < n := @tnext_lt T j ok.
have [_ _ /(_ lt_tn) tw_i] := pa i lt_in; have [step_k lab_k tw_k] := pa k lt_kn.
split; last by move/tw_k.
  rewrite flip_nextE // tw_i /prev !step ?lt_next // !f_eq ?lt_next //.
  by rewrite /flip_table /tnext /= nth_mkseq // !(fun_if f).
rewrite flip_originE // tw_i !(patch_corner ok pa) // !f_eq //.
by rewrite /flip_table /tlabel /= nth_mkseq // !(fun_if l) lab_k.
Qed.

Lemma patch_flip_outside s T i x : well_formed s -> apart s (f i) -> table_ok n T ->
    i < n -> nth n tw i < n -> patch s T -> outside x ->
  next (flip (f i) s) x = next s x /\ origin (flip (f i) s) x = origin s x.
Proof.
move=> wf ap ok lt_in lt_tn pa out.
have step j : j < n -> next s (f j) = f (tnext T j) by move=> lt_jn; have [] := pa j lt_jn.
have lt_next j : j < n -> tnext T j < n := @tnext_lt T j ok.
have [_ _ /(_ lt_tn) tw_i] := pa i lt_in.
rewrite flip_nextE // flip_originE // tw_i /prev !step ?lt_next //.
by rewrite !(negbTE (out _ _)) ?lt_next.
Qed.

(* What flips inside a patch do is what they do to its table. *)
Theorem patch_run p s T : good s -> run_ok n m tw p T -> patch s T ->
  exists s', [/\ reach_in s (size p) s', good s', patch s' (run n tw p T), twin s' = twin s &
    forall x, outside x -> next s' x = next s x /\ origin s' x = origin s x].
Proof.
elim: p s T => [|i p IHp] s T gd.
  by move=> _ pa; exists s; split=> //; apply: reach_in0.
case/and3P=> ok /and5P[lt_in lt_tn lt_ci lt_ct labs] ok_p pa.
have [_ _ /(_ lt_tn) tw_i] := pa i lt_in.
have al : allowed s (f i).
  rewrite /allowed tw_i !(patch_corner ok pa) //.
  by apply: contra labs => /eqP /l_inj ->.
have ap := allowed_apart (good_wf gd) al.
have pa' := patch_flip (good_wf gd) ap ok lt_in lt_tn pa.
have [s' [r gd' pas' tws' out']] := IHp _ _ (flip_good gd al) ok_p pa'.
exists s'; split=> // [|x outx]; first exact: reach_inS al r.
have [-> ->] := out' x outx; exact: patch_flip_outside (good_wf gd) ap ok lt_in lt_tn pa outx.
Qed.

End Patch.

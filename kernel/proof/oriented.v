(* Orientable surfaces and oriented ones.

   An oriented surface (surface.v) is a signed one none of whose sides is reversed: well-formedness
   and the flip are the same there ([unsigned_well_formed], [unsigned_flip]).  And a signed
   surface is orientable exactly where turning over some of its faces makes it oriented
   ([orientable_turned]).  So the Theorem 4.2 of invariants.v is that of orientability.v for the
   orientable surfaces. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip signed orientability.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Oriented surfaces are those without reversed sides; their flip is the same. *)
Definition unsigned (D V : finType) (s : surface D V) := Signed s [ffun => false].

Section Unsigned.

Variables D V : finType.
Implicit Types (s : surface D V) (h : D).

Lemma unsigned_orientable s : orientable (unsigned s).
Proof. by exists (fun => false); split=> x //; rewrite ffunE. Qed.

Lemma unsigned_flip s h : signed_flip h (unsigned s) = unsigned (flip h s).
Proof. by rewrite /signed_flip /straightened ffunE. Qed.

Let cnext_false s x : cnext (unsigned s) (x, false) = (next s x, false).
Proof. by rewrite cnextE. Qed.

Let csigma_false s x : csigma (unsigned s) (x, false) = (sigma s x, false).
Proof. by rewrite csigmaE ctwinE /= ffunE cnext_false sigmaE. Qed.

Let porbit_false s x w :
  (w \in porbit (csigma (unsigned s)) (x, false)) = ~~ w.2 && (w.1 \in porbit (sigma s) x).
Proof.
have iter_false k : (csigma (unsigned s) ^+ k)%g (x, false) = ((sigma s ^+ k)%g x, false).
  elim: k => [|k IHk]; first by rewrite !expg0 !perm1.
  by rewrite !expgSr permM [in RHS]permM IHk csigma_false.
apply/porbitP/andP => [[k ->] | [w2 /porbitP[k w1]]].
  by rewrite iter_false mem_porbit.
by exists k; rewrite iter_false -w1; case: w w2 {w1} => y [].
Qed.

(* Each dart of the cover starts in the same corner as one of the first copy. *)
Let first_copy s (z : D * bool) := if z.2 then next s z.1 else z.1.

Let clabel_first s z : clabel (unsigned s) z = origin s (first_copy s z).
Proof. by case: z => x []. Qed.

Let first_copyE s z : (first_copy s z, false) = if z.2 then around (unsigned s) z else z.
Proof. by case: z => x []; rewrite /first_copy /around /over //= cnext_false. Qed.

Let vertex_first s z w : glued (unsigned s) ->
  (w \in porbit (csigma (unsigned s)) z) ||
    (w \in porbit (csigma (unsigned s)) (around (unsigned s) z)) =
  (first_copy s w \in porbit (sigma s) (first_copy s z)).
Proof.
move=> gl; set u := unsigned s; set sg := csigma u.
have other v v' : (around u v' \in porbit sg v) = (v' \in porbit sg (around u v)).
  by rewrite -(around_porbit gl) aroundK.
have first x : (w \in porbit sg (x, false)) || (w \in porbit sg (around u (x, false))) =
    (first_copy s w \in porbit (sigma s) x).
  rewrite -other !porbit_false; case: w => y [] /=; first by rewrite /around /over cnext_false.
  by rewrite /around /over cnextE orbF.
case: z => x [] /=; last exact: first.
have back : around u (x, true) = (next s x, false) by rewrite /around /over cnext_false.
by rewrite -first -back aroundK orbC.
Qed.

(* Well-formedness of the one and of the other are the same. *)
Theorem unsigned_well_formed s : signed_well_formed (unsigned s) <-> well_formed s.
Proof.
split=> [[gl label used] | wf].
  have [tK t_neq n3 n_neq _] := gl; split=> // x y.
  have := label (x, false) (y, false); rewrite vertex_first //.
have gl : glued (unsigned s).
  by case: wf => tK t_neq n3 n_neq _ _; split=> // x; rewrite !ffunE.
split=> //; last exact: label_used wf.
by move=> z w; rewrite vertex_first // !clabel_first (label_orbit wf).
Qed.

End Unsigned.

(* Turning over one face after the other. *)
Inductive turned (D V : finType) (s : signed D V) : signed D V -> Prop :=
| turned0 : turned s s
| turnedS x s' : turned (turn_over x s) s' -> turned s s'.

(* What orientable means: some faces can be turned over so that an oriented surface is left. *)
Theorem orientable_turned (D V : finType) (s : signed D V) : signed_well_formed s ->
  orientable s <-> exists2 s1 : surface D V, well_formed s1 & turned s (unsigned s1).
Proof.
move=> wf; split; last first.
  case=> s1 _; move def_u: (unsigned s1) => u to_u.
  elim: to_u wf def_u => {s u} [s _ <-|s x u _ IH wf def_u].
    exact: unsigned_orientable.
  have [gl _ _] := wf; apply/(turn_over_orientable gl x); apply: IH => //.
  exact: turn_over_well_formed.
case=> o []; have [n] := ubnP #|[set x | o x]|.
elim: n s wf o => // n IHn s wf o le_n o_next o_twin.
have [gl _ _] := wf; case: (pickP o) => [x ox | no_o].
  pose o' y := o y (+) same_face (base s) x y.
  have face_o y : same_face (base s) x y -> o y.
    by rewrite (glued_same_face gl) => /or3P[] /eqP->; rewrite /= /prev ?o_next.
  have [|||s1 wf1 to_s1] := IHn (turn_over x s) (turn_over_well_formed gl x wf) o'.
  - apply: leq_trans (_ : _ < #|[set y | o y]|) _; last by rewrite -ltnS.
    apply: proper_card; apply/properP; split; last first.
      by exists x; rewrite !inE ?ox // /o' ox same_face_refl.
    apply/subsetP => y; rewrite !inE /o'; case Fy: (same_face _ _ y); last by rewrite addbF.
    by rewrite face_o.
  - by have [] := turned_orientation gl x (conj o_next o_twin).
  - by have [] := turned_orientation gl x (conj o_next o_twin).
  by exists s1 => //; apply: turnedS to_s1.
have def_s : s = unsigned (base s).
  case: (s) no_o o_twin => b r no_o o_twin; congr Signed; apply/ffunP => x; rewrite ffunE.
  by have := o_twin x; rewrite !no_o.
exists (base s); last by rewrite -def_s; apply: turned0.
by apply/unsigned_well_formed; rewrite -def_s.
Qed.

(* Surfaces whose orientability may fail.

   Each side of a face has a bit: [reversed] says that the side is glued to its twin against the
   directions of their faces, so that both run the same way.  [orientable]: some faces can be
   turned over so that no side is reversed.

   The double cover has two copies of each face, one for each of its two directions; its darts
   are pairs (x, e), the side x run along (e = false) or against (e = true) the direction of its
   face.  The cover is oriented.  Turning about a vertex is [csigma], in the cover; each vertex is
   there twice, once for each way of turning, and [around] leads from the one to the other. *)

From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* A surface with its vertices as labels: what is proved of well-formed surfaces can be used where
   only twin and next are known. *)
Section Named.

Variable D : finType.
Variables t n : {perm D}.

Definition orbit_name := [finType of {A : {set D} | A \in porbits (t * n)%g}].

Lemma mem_porbits x : porbit (t * n)%g x \in porbits (t * n)%g.
Proof. exact: imset_f. Qed.

Definition name_of x : orbit_name :=
  exist (fun A => A \in porbits (t * n)%g) _ (mem_porbits x).
Definition named : surface D orbit_name := Surface t n [ffun x => name_of x].

Hypothesis tK : involutive t.
Hypothesis t_neq : forall x, t x != x.
Hypothesis n3 : forall x, n (n (n x)) = x.
Hypothesis n_neq : forall x, n x != x.

Lemma named_well_formed : well_formed named.
Proof.
split=> // [x y | v].
  by rewrite !ffunE -val_eqE /= eq_porbit_mem porbit_sym.
have /imsetP[x _ def_v] := valP v; exists x.
by rewrite ffunE; apply: val_inj; rewrite /= def_v.
Qed.

End Named.

Record signed (D V : finType) := Signed { base : surface D V; reversed : {ffun D -> bool} }.

Section Model.

Variables D V : finType.
Implicit Types (s : signed D V) (x y h : D) (z w : D * bool).

(* The same side, run the other way. *)
Definition over z := (z.1, ~~ z.2).

Definition cnext_fun s z :=
  (if z.2 then (next (base s))^-1%g z.1 else next (base s) z.1, z.2).
Definition ctwin_fun s z := (twin (base s) z.1, z.2 (+) reversed s z.1).

Lemma cnext_inj s : injective (cnext_fun s).
Proof. by case=> x [] [y []] // [/perm_inj->]. Qed.

Lemma ctwin_inj s : injective (ctwin_fun s).
Proof. by case=> x e [y e'] [/perm_inj-> /addIb->]. Qed.

(* The next dart of the face, and the twin, in the double cover. *)
Definition cnext s : {perm D * bool} := perm (@cnext_inj s).
Definition ctwin s : {perm D * bool} := perm (@ctwin_inj s).
Definition csigma s : {perm D * bool} := (ctwin s * cnext s)%g.

(* Where a dart of the cover starts, and the other dart that starts in the same corner. *)
Definition clabel s z := if z.2 then origin (base s) (next (base s) z.1) else origin (base s) z.1.
Definition around s z := cnext s (over z).

(* Triangles, each side glued to one other, both with the same bit. *)
Record glued s : Prop := Glued {
  glued_twinK : involutive (twin (base s));
  glued_twin_neq : forall x, twin (base s) x != x;
  glued_next3 : forall x, next (base s) (next (base s) (next (base s) x)) = x;
  glued_next_neq : forall x, next (base s) x != x;
  reversed_twin : forall x, reversed s (twin (base s) x) = reversed s x }.

(* Labels name the vertices. *)
Record signed_well_formed s : Prop := SignedWellFormed {
  signed_glued : glued s;
  signed_label : forall z w, (clabel s z == clabel s w) =
    (w \in porbit (csigma s) z) || (w \in porbit (csigma s) (around s z));
  signed_used : forall v, exists x, origin (base s) x = v }.

(* When the faces in o are turned over, all sides run against their twins. *)
Definition orientation s (o : D -> bool) :=
  (forall x, o (next (base s) x) = o x) /\
  (forall x, o (twin (base s) x) = o x (+) reversed s x).
Definition orientable s := exists o, orientation s o.

(* The number of vertices: half of those of the cover. *)
Definition signed_vertices s := #|porbits (csigma s)|./2.

Lemma cnextE s z : cnext s z = (if z.2 then (next (base s))^-1%g z.1 else next (base s) z.1, z.2).
Proof. by rewrite permE. Qed.

Lemma ctwinE s z : ctwin s z = (twin (base s) z.1, z.2 (+) reversed s z.1).
Proof. by rewrite permE. Qed.

Lemma csigmaE s z : csigma s z = cnext s (ctwin s z).
Proof. by rewrite permM. Qed.

Lemma overK : involutive over.
Proof. by case=> x e; rewrite /over /= negbK. Qed.

Lemma over_next s z : over (cnext s (over (cnext s z))) = z.
Proof. by case: z => x []; rewrite /over !cnextE /= ?permK ?permKV. Qed.

Lemma over_twin s z : ctwin s (over z) = over (ctwin s z).
Proof. by case: z => x e; rewrite /over !ctwinE /= addNb. Qed.

Lemma aroundK s : involutive (around s).
Proof. by move=> z; rewrite /around -[RHS](overK z) -[in RHS](over_next s (over z)) overK. Qed.

Lemma clabel_around s z : clabel s (around s z) = clabel s z.
Proof. by case: z => x []; rewrite /clabel /around /over cnextE //= permKV. Qed.

End Model.

(* Turning one way about a vertex never leads to the same corner the other way: each vertex is
   twice in the cover. *)
Section Twice.

Variables D V : finType.
Variable s : signed D V.
Hypothesis gl : glued s.
Implicit Types z w : D * bool.

Lemma named_base_well_formed : well_formed (named (twin (base s)) (next (base s))).
Proof. by case: gl => tK t_neq n3 n_neq _; apply: named_well_formed. Qed.

Lemma glued_same_face x y :
  same_face (base s) x y = [|| y == x, y == next (base s) x | y == prev (base s) x].
Proof. exact: (same_faceE named_base_well_formed). Qed.

Lemma next_inv x : (next (base s))^-1%g x = prev (base s) x.
Proof. by apply: (canLR (permK _)); rewrite /prev (glued_next3 gl). Qed.

Lemma ctwinK : involutive (ctwin s).
Proof.
by case=> x e; rewrite !ctwinE /= (glued_twinK gl) (reversed_twin gl) -addbA addbb addbF.
Qed.

Lemma around_csigma z : around s (csigma s z) = ctwin s (over z).
Proof.
by rewrite csigmaE /around over_twin -[RHS]overK -[in RHS](over_next s (ctwin s z)) !overK.
Qed.

Lemma csigma_around z : csigma s (around s (csigma s z)) = around s z.
Proof. by rewrite around_csigma csigmaE ctwinK. Qed.

Lemma around_iter k z : around s z != iter k (csigma s) z.
Proof.
elim/ltn_ind: k z => -[|[|k]] IHk z; apply/eqP.
- by case: z => x []; rewrite /around /over cnextE /= => -[].
- move=> /= fixed; have := around_csigma z; rewrite -fixed aroundK.
  case: z {fixed} => x e; rewrite ctwinE /= => -[/esym/eqP].
  by rewrite (negbTE (glued_twin_neq gl x)).
rewrite iterSr iterS => fixed; case/eqP: (IHk k (leqnSn _) (csigma s z)).
by apply: (@perm_inj _ (csigma s)); rewrite csigma_around fixed.
Qed.

Lemma around_out z : around s z \notin porbit (csigma s) z.
Proof.
by apply/negP => /porbitP[k]; apply/eqP; rewrite permX around_iter.
Qed.

(* What lies in one orbit lies in one orbit on the other side. *)
Lemma around_porbit z w :
  (around s w \in porbit (csigma s) (around s z)) = (w \in porbit (csigma s) z).
Proof.
have step u : porbit (csigma s) (around s (csigma s u)) = porbit (csigma s) (around s u).
  by rewrite -(csigma_around u) -[in RHS](expg1 (csigma s)) porbit_perm.
have half u v : v \in porbit (csigma s) u -> around s v \in porbit (csigma s) (around s u).
  case/porbitP=> k ->; rewrite -eq_porbit_mem; apply/eqP.
  by elim: k => [|k IHk]; rewrite ?expg0 ?perm1 // expgSr permM step.
by apply/idP/idP => /half; rewrite ?aroundK.
Qed.

End Twice.

(* The labels at the two ends of a side and of its twin. *)
Definition ends_match (D V : finType) (s : signed D V) := forall x,
  origin (base s) (twin (base s) x) =
    (if reversed s x then origin (base s) x else origin (base s) (next (base s) x)) /\
  origin (base s) (next (base s) (twin (base s) x)) =
    (if reversed s x then origin (base s) (next (base s) x) else origin (base s) x).

Lemma constant_ends (D V : finType) (s : signed D V) :
  (forall z, clabel s (csigma s z) = clabel s z) <-> ends_match s.
Proof.
split=> [constant x | ends [x e]]; last first.
  rewrite csigmaE ctwinE cnextE /clabel /=; have [e1 e2] := ends x.
  by case: e; case: (reversed s x) e1 e2 => /= e1 e2; rewrite ?permKV.
have := constant (x, false); have := constant (x, true).
rewrite !csigmaE !ctwinE !cnextE /clabel /=.
by case: (reversed s x) => /= e1 e2; rewrite ?permKV in e1 e2.
Qed.

(* Labels name the vertices where they are the same about each vertex, all are used, and there are
   as many as vertices. *)
Section Labels.

Variables D V : finType.
Variable s : signed D V.
Hypothesis gl : glued s.
Hypothesis constant : forall z, clabel s (csigma s z) = clabel s z.
Hypothesis used : forall v, exists x, origin (base s) x = v.
Implicit Types z w : D * bool.

Lemma clabel_porbit z w : w \in porbit (csigma s) z -> clabel s w = clabel s z.
Proof.
case/porbitP=> k ->; elim: k => [|k IHk]; first by rewrite expg0 perm1.
by rewrite expgSr permM constant.
Qed.

(* A dart for each label, and the two orbits of the cover at it. *)
Let used_by v : exists x, origin (base s) x == v.
Proof. by have [x <-] := used v; exists x. Qed.
Let dart_of v : D * bool := (xchoose (used_by v), false).
Let vertex_of (ve : V * bool) :=
  porbit (csigma s) (if ve.2 then around s (dart_of ve.1) else dart_of ve.1).

Let clabel_dart_of v : clabel s (dart_of v) = v.
Proof. exact/eqP/(xchooseP (used_by v)). Qed.

Let clabel_vertex_of ve z : z \in vertex_of ve -> clabel s z = ve.1.
Proof.
by case: ve => v e /clabel_porbit->; case: e; rewrite /= ?clabel_around clabel_dart_of.
Qed.

Let vertex_of_inj : injective vertex_of.
Proof.
have differ v : vertex_of (v, true) <> vertex_of (v, false).
  move=> eq_v; have /negP[] := around_out gl (dart_of v).
  by rewrite -[porbit _ _]/(vertex_of (v, false)) -eq_v porbit_id.
have label_of ve : exists2 z, z \in vertex_of ve & clabel s z = ve.1.
  exists (if ve.2 then around s (dart_of ve.1) else dart_of ve.1); first exact: porbit_id.
  by case: ve => v [] /=; rewrite ?clabel_around clabel_dart_of.
move=> [v e] [v' e'] eq_ve; have [z z_in def_v] := label_of (v, e).
have := z_in; rewrite eq_ve => /clabel_vertex_of; rewrite def_v /= => eq_v.
move: eq_ve; rewrite -eq_v; case: e {z_in def_v}; case: e' => // eq_ve; first by case: (differ v).
by case: (differ v).
Qed.

Let vertex_of_porbits : vertex_of @: setT \subset porbits (csigma s).
Proof. by apply/subsetP => _ /imsetP[ve _ ->]; apply: imset_f. Qed.

Let card_vertex_of : #|vertex_of @: setT| = 2 * #|V|.
Proof. by rewrite card_imset // cardsT card_prod card_bool mulnC. Qed.

Let mem_vertex_of z ve : z \in vertex_of ve -> porbit (csigma s) z = vertex_of ve.
Proof. by rewrite -eq_porbit_mem => /eqP. Qed.

Lemma label_count : #|porbits (csigma s)| = 2 * #|V| <->
  forall z w, (clabel s z == clabel s w) =
    (w \in porbit (csigma s) z) || (w \in porbit (csigma s) (around s z)).
Proof.
split=> [count z w | exact_labels]; last first.
  rewrite -card_vertex_of; apply/eqP; rewrite eqn_leq [X in _ && X]subset_leq_card // andbT.
  apply: subset_leq_card.
  apply/subsetP => _ /imsetP[z _ ->]; have := exact_labels (dart_of (clabel s z)) z.
  rewrite clabel_dart_of eqxx => /esym/orP[] z_in; apply/imsetP.
    by exists (clabel s z, false) => //; apply: mem_vertex_of.
  by exists (clabel s z, true) => //; apply: mem_vertex_of.
apply/eqP/orP => [eq_l | [] /clabel_porbit ->]; rewrite ?clabel_around //.
have onto u : exists e, u \in vertex_of (clabel s u, e).
  have : porbit (csigma s) u \in vertex_of @: setT.
    have /eqP -> : vertex_of @: setT == porbits (csigma s).
      by rewrite eqEcard vertex_of_porbits card_vertex_of count leqnn.
    exact: imset_f.
  case/imsetP => -[v e] _ def_u; have u_in : u \in vertex_of (v, e) by rewrite -def_u porbit_id.
  by exists e; rewrite (clabel_vertex_of u_in).
have [e z_in] := onto z; have [e' w_in] := onto w; rewrite -eq_l in w_in.
have [eq_e | neq_e] := eqVneq e e'.
  by left; rewrite (mem_vertex_of z_in) eq_e.
right; have z_around : around s z \in vertex_of (clabel s z, e').
  move: z_in neq_e; rewrite /vertex_of /=; case: e e' {w_in} => -[] //.
    by rewrite -{1}(aroundK s z) around_porbit.
  by rewrite -around_porbit.
by rewrite (mem_vertex_of z_around).
Qed.

End Labels.

(* Turning a face over: its sides run the other way, and so their bits change, twice where the
   twin lies in the same face. *)
Definition turn_over (D V : finType) x (s : signed D V) : signed D V :=
  let b := base s in
  Signed (Surface (twin b) (next b ^ tperm (next b x) (next b (next b x)))%g
            [ffun y => if same_face b x y then origin b (next b y) else origin b y])
         [ffun y => reversed s y (+) same_face b x y (+) same_face b x (twin b y)].

Section TurnOver.

Variables D V : finType.
Variable s : signed D V.
Hypothesis gl : glued s.
Variable x : D.

Let b := base s.
Let s' := turn_over x s.
Let F := same_face b x.

Let wf0 := named_base_well_formed gl.
Let b3 y : next b (next b (next b y)) = y. Proof. exact: (glued_next3 gl). Qed.
Let b_eq y z : (next b y == next b z) = (y == z).
Proof. exact: (inj_eq (@perm_inj _ (next b))). Qed.

Let FE y : F y = [|| y == x, y == next b x | y == prev b x].
Proof. exact: glued_same_face. Qed.

Let F_next y : F (next b y) = F y. Proof. exact: same_face_next. Qed.

Let F_inv y : F ((next b)^-1%g y) = F y. Proof. by rewrite -F_next permKV. Qed.

(* Next runs backwards in the face of x. *)
Lemma turned_next y : next (base s') y = if F y then prev b y else next b y.
Proof.
have n1 : next b x != x := glued_next_neq gl x.
have n2 : prev b x != x by rewrite /prev -(b_eq _ x) b3 eq_sym.
set tau := tperm (next b x) (next b (next b x)).
have tx : tau x = x by rewrite tpermD.
have new z w : tau z = w -> next (base s') w = tau (next b z) by move=> <-; apply: permJ.
rewrite FE; have [->|yx] := eqVneq y x; first by rewrite (new x) // tpermL.
have [->|yn] /= := eqVneq y (next b x).
  by rewrite (new (next b (next b x))) ?tpermR // /prev !b3 tx.
have [->|yp] /= := eqVneq y (prev b x).
  by rewrite (new (next b x)) ?tpermL // tpermR /prev b3.
by rewrite (new y) ?tpermD // eq_sym // b_eq.
Qed.

Lemma turned_prev y : prev (base s') y = if F y then next b y else prev b y.
Proof. by rewrite /prev !turned_next /prev; case Fy: (F y); rewrite ?F_next Fy // !b3. Qed.

Lemma turned_next_inv y :
  (next (base s'))^-1%g y = if F y then next b y else (next b)^-1%g y.
Proof.
apply: (canLR (permK _)); rewrite turned_next; case Fy: (F y); first by rewrite F_next Fy /prev b3.
by rewrite F_inv Fy permKV.
Qed.

Lemma turned_origin y : origin (base s') y = if F y then origin b (next b y) else origin b y.
Proof. by rewrite ffunE. Qed.

Lemma turned_origin_next y :
  origin (base s') (next (base s') y) = if F y then origin b y else origin b (next b y).
Proof.
by rewrite turned_origin turned_next; case Fy: (F y); rewrite /prev !F_next Fy ?b3.
Qed.

Lemma turned_corner y : corner (base s') y = corner b y.
Proof.
rewrite /corner turned_prev turned_origin; case Fy: (F y); first by rewrite F_next Fy.
by rewrite /prev !F_next Fy.
Qed.

Lemma turned_reversed y : reversed s' y = reversed s y (+) F y (+) F (twin b y).
Proof. by rewrite ffunE. Qed.

Lemma turn_over_glued : glued s'.
Proof.
have [tK t_neq n3 n_neq rev] := gl; split=> [//|//|y|y|y].
- by rewrite 3!turned_next; case Fy: (F y); rewrite /prev ?F_next ?Fy ?F_next ?Fy // /prev !b3.
- by rewrite turned_next; case: (F y); rewrite // /prev -(b_eq _ y) b3 eq_sym.
- by rewrite !turned_reversed -[twin (base s') y]/(twin b y) rev tK addbAC.
Qed.

Lemma turned_same_face y z : same_face (base s') y z = same_face b y z.
Proof.
rewrite (glued_same_face turn_over_glued) (glued_same_face gl) turned_prev turned_next.
case: (F y) => //.
by rewrite [(z == next b y) || _]orbC.
Qed.

(* In the cover, the copies of the face change places. *)
Definition exchange_copies (z : D * bool) := (z.1, z.2 (+) F z.1).

Lemma turned_csigma z : csigma s' (exchange_copies z) = exchange_copies (csigma s z).
Proof.
have turned_cnext w : cnext s' (exchange_copies w) = exchange_copies (cnext s w).
  case: w => y e; rewrite !cnextE /exchange_copies /= turned_next turned_next_inv.
  case: e; rewrite ?F_next ?F_inv; case: (F y) => //=.
  - by rewrite /prev; congr (_, _); apply: (canRL (permK _)); rewrite b3.
rewrite !csigmaE -turned_cnext; congr (cnext _ _).
case: z => y e; rewrite !ctwinE /exchange_copies /= turned_reversed.
by congr (_, _); case: e; case: (reversed s y); case: (F y); case: (F _).
Qed.

Lemma turned_around z : around s' (exchange_copies z) = exchange_copies (around s z).
Proof.
case: z => y e; rewrite /around /over !cnextE /exchange_copies /= turned_next turned_next_inv.
case: e; rewrite ?F_next ?F_inv; case: (F y) => //=.
by rewrite /prev; congr (_, _); apply: (canRL (permK _)); rewrite b3.
Qed.

Lemma turned_clabel z : clabel s' (exchange_copies z) = clabel s z.
Proof.
case: z => y e; rewrite /clabel /exchange_copies /= turned_origin_next turned_origin.
by case: e; case: (F y).
Qed.

Lemma exchange_copiesK : involutive exchange_copies.
Proof. by case=> y e; rewrite /exchange_copies /= -addbA addbb addbF. Qed.

Lemma turned_porbit z w :
  (exchange_copies w \in porbit (csigma s') (exchange_copies z)) = (w \in porbit (csigma s) z).
Proof.
have iter_exchange k :
    (csigma s' ^+ k)%g (exchange_copies z) = exchange_copies ((csigma s ^+ k)%g z).
  elim: k => [|k IHk]; first by rewrite !expg0 !perm1.
  by rewrite !expgSr permM [in RHS]permM IHk turned_csigma.
apply/porbitP/porbitP => -[k]; rewrite ?iter_exchange.
  by move/(can_inj exchange_copiesK) => ->; exists k.
by move=> ->; exists k; rewrite iter_exchange.
Qed.

Theorem turn_over_well_formed : signed_well_formed s -> signed_well_formed s'.
Proof.
case=> _ label used; split; first exact: turn_over_glued.
  move=> z w; rewrite -[z]exchange_copiesK -[w]exchange_copiesK turned_around !turned_clabel.
  by rewrite !turned_porbit label.
move=> v; have [y <-] := used v; case Fy: (F y).
  by exists (prev b y); rewrite turned_origin /prev !F_next Fy b3.
by exists y; rewrite turned_origin Fy.
Qed.

Lemma turned_orientation o : orientation s o -> orientation s' (fun y => o y (+) F y).
Proof.
case=> o_next o_twin; split=> y.
  by rewrite turned_next; case Fy: (F y); rewrite /prev !F_next !o_next Fy.
rewrite turned_reversed -[twin (base s') y]/(twin b y) o_twin.
by case: (o y); case: (reversed s y); case: (F y); case: (F _).
Qed.

Theorem turn_over_orientable : orientable s' <-> orientable s.
Proof.
split=> -[o]; last by exists (fun y => o y (+) F y); apply: turned_orientation.
case=> o_next o_twin; exists (fun y => o y (+) F y); split=> y.
  rewrite F_next; congr (_ (+) _); case Fy: (F y).
    by have := o_next (next b y); rewrite turned_next F_next Fy /prev b3 => ->.
  by have := o_next y; rewrite turned_next Fy.
have := o_twin y; rewrite turned_reversed -[twin (base s') y]/(twin b y) => ->.
by case: (o y); case: (reversed s y); case: (F y); case: (F _).
Qed.

(* Connectedness, loops and guards are as before. *)
Theorem turn_over_connected : connected (base s') <-> connected b.
Proof.
split=> con y z; have := con y z; apply: connect_sub => {y z} y z /orP[] /eqP->.
- by apply: connect1; rewrite /link eqxx.
- rewrite turned_next; case: (F y); last by apply: connect1; rewrite /link eqxx orbT.
  by apply: (@connect_trans _ _ (next b y)); apply: connect1; rewrite /link eqxx orbT.
- by apply: connect1; rewrite /link eqxx.
case Fy: (F y).
  apply: (@connect_trans _ _ (prev b y)).
    by apply: connect1; rewrite /link turned_next Fy eqxx orbT.
  have -> : next b y = next (base s') (prev b y) by rewrite turned_next /prev !F_next Fy b3.
  by apply: connect1; rewrite /link eqxx orbT.
by apply: connect1; rewrite /link turned_next Fy eqxx orbT.
Qed.

Theorem turn_over_loopless : loopless (base s') <-> loopless b.
Proof.
split=> lf y; have := lf y; rewrite turned_origin_next turned_origin; case: (F y) => //;
  by rewrite eq_sym.
Qed.

Lemma turn_over_allowed h : allowed (base s') h = allowed b h.
Proof. by rewrite /allowed !turned_corner. Qed.

Lemma turn_over_apart h : apart (base s') h = apart b h.
Proof. by rewrite /apart turned_same_face. Qed.

End TurnOver.

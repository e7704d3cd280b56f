(* What the programs of tables.v mean.

   [represents d v s tb]: the table tb is the surface s, where the dart x has the number d x and the
   vertex w the number v w.  Proved here:
   - [flip_table_refines]: on a table that represents a well-formed surface, [flip_table] does
     the abstract flip where it is allowed, and says so where it is not; entries of other numbers
     stay as they are.  Glued outer darts are no special case.  [unflip_table_refines]: the inverse;
   - [audit_sound]: a table that passes [audit] represents a well-formed, loopless, connected
     surface of the genus it says, with darts bool * 'I_n and vertices 'I_v;
   - [same_by_sound]: two such tables that pass [same_by] are the same labelled surface;
   - [certificate_sound]: a certificate that passes joins its two ends by allowed flips. *)

From Coq Require Import PArith NArith Lia.
From mathcomp Require Import all_ssreflect all_fingroup.
From Tightflip Require Import surface flip invariants order reach tables.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* Tables and abstract surfaces *)
Section Refinement.

Variables D V : finType.
Variables (d : D -> positive) (v : V -> positive).
Hypothesis d_inj : injective d.
Hypothesis v_inj : injective v.
Implicit Types (s : surface D V) (x y h : D) (tb : table).

Definition represents s tb :=
  (forall x, twin_dart (d x) = d (twin s x)) /\
  (forall x, get (d x) tb = Some (d (next s x), v (origin s x))).

Lemma get_add x y e tb : get (d x) (M.add (d y) e tb) = if x == y then Some e else get (d x) tb.
Proof.
case: eqP => [->|neq]; first exact: M.gss.
by apply: M.gso => /d_inj.
Qed.

(* The table flip does the abstract flip, or refuses where that is not allowed. *)
Theorem flip_table_refines s tb h : well_formed s -> represents s tb ->
  if allowed s h then
    exists tb', [/\ flip_table (d h) tb = Done tb', represents (flip h s) tb' &
      forall p, (forall x, x \in quad s h -> d x <> p) -> get p tb' = get p tb]
  else flip_table (d h) tb = Refused.
Proof.
move=> wf [tw rep]; rewrite /flip_table /turn_edge tw !rep -/(prev s h) -/(prev s (twin s h)).
rewrite -/(corner s h) -/(corner s (twin s h)).
case: ifP => [ok|]; last first.
  by rewrite /allowed => /negbFE/eqP->; rewrite Pos.eqb_refl.
have hap := allowed_apart wf ok; set t := twin s h in ok *.
have -> : Pos.eqb (v (corner s h)) (v (corner s t)) = false.
  by apply/Pos.eqb_neq => /v_inj /eqP; apply/negP.
have E := quad_neqs wf hap; rewrite -/t in E.
eexists; split; first by []; last first.
  move=> p out; rewrite /get !M.gso //; apply/nesym/out;
    by rewrite !inE eqxx ?orbT.
split=> [x|x]; first exact: tw.
rewrite !get_add rep flip_nextE // flip_originE -/t.
case: (x =P h) => [//|_]; case: (x =P t) => [->|_]; first by rewrite !E.
case: (x =P prev s h) => [->//|_]; case: (x =P next s t) => [->//|_].
by case: (x =P prev s t) => [->//|_]; case: (x =P next s h) => [->|].
Qed.

(* The inverse, in the same way. *)
Theorem unflip_table_refines s tb h : well_formed s -> represents s tb ->
  if allowed s h then
    exists tb', [/\ unflip_table (d h) tb = Done tb', represents (unflip h s) tb' &
      forall p, (forall x, x \in quad s h -> d x <> p) -> get p tb' = get p tb]
  else unflip_table (d h) tb = Refused.
Proof.
move=> wf [tw rep]; rewrite /unflip_table /turn_edge !tw !rep -/(prev s h) -/(prev s (twin s h)).
rewrite -/(corner s h) -/(corner s (twin s h)).
case: ifP => [ok|]; last first.
  by rewrite /allowed => /negbFE/eqP->; rewrite Pos.eqb_refl.
have hap := allowed_apart wf ok; set t := twin s h in ok *.
have -> : Pos.eqb (v (corner s h)) (v (corner s t)) = false.
  by apply/Pos.eqb_neq => /v_inj /eqP; apply/negP.
have E := quad_neqs wf hap; rewrite -/t in E.
have tK : twin s t = h by apply: twinK.
rewrite tK; eexists; split; first by []; last first.
  move=> p out; rewrite /get !M.gso //; apply/nesym/out;
    by rewrite !inE -?/t eqxx ?orbT.
split=> [x|x]; first exact: tw.
have next_x : next (unflip h s) x = tperm h t (next (flip h s) (tperm h t x)).
  by rewrite unflip_rename // -{1}(tpermK h t x) permJ.
rewrite !get_add rep next_x flip_nextE // ffunE -/t.
have [->|xt] := eqVneq x t; first by rewrite tpermR eqxx tpermD ?E // eq_sym E.
have [->|xh] := eqVneq x h; first by rewrite tpermL !E !eqxx tpermD ?E // eq_sym ?E.
rewrite [tperm h t x]tpermD; try by rewrite eq_sym.
rewrite (negbTE xh) (negbTE xt); case: (x =P prev s h) => [->|/eqP xb].
  by rewrite tpermD // eq_sym E.
case: (x =P next s t) => [->|/eqP xt1]; first by rewrite tpermL.
case: (x =P prev s t) => [->|/eqP xd]; first by rewrite tpermD // eq_sym E.
case: (x =P next s h) => [->|/eqP xh1]; first by rewrite tpermR.
have nh : next s x != h.
  by rewrite -(prevK wf h) (inj_eq (@next_inj _ _ s)); apply: contraNneq xb => ->.
have nt : next s x != t by rewrite -(prevK wf t) (inj_eq (@next_inj _ _ s)).
by rewrite tpermD // eq_sym.
Qed.

End Refinement.

(* Loops that count *)

Lemma iter_count (A : Type) (g : positive -> A -> A) (P : positive -> A -> Prop) a n :
    P 1%positive a ->
    (forall k x, (k <= n)%positive -> P k x -> P (Pos.succ k) (g k x)) ->
  forall st, st = Pos.iter (fun st => (Pos.succ st.1, g st.1 st.2)) (1%positive, a) n ->
  st.1 = Pos.succ n /\ P (Pos.succ n) st.2.
Proof.
move=> P1 step st ->; set loop := Pos.iter _ _.
suff upto m : (m <= n)%positive -> (loop m).1 = Pos.succ m /\ P (Pos.succ m) (loop m).2.
  by apply: upto; lia.
elim/Pos.peano_ind: m => [|m IHm] m_le_n /=.
  by split=> //; exact: (step 1%positive a m_le_n P1).
rewrite /loop Pos.iter_succ -/loop; case: IHm => [|e Pm]; first by lia.
by rewrite /= e; split=> //; apply: step.
Qed.

Lemma all_upto_count n f : all_upto n f ->
  forall k, (k <= n)%positive -> f k.
Proof.
pose P k (b : bool) := b -> forall j, (j < k)%positive -> f j.
have P1 : P 1%positive true by move=> _ j; lia.
have step k b : (k <= n)%positive -> P k b -> P (Pos.succ k) (if b then f k else false).
  case: b => // _ Pk fk j j_le.
  have [j_lt|->] : (j < k)%positive \/ j = k by lia.
    exact: Pk.
  by [].
have [_ Pn] := @iter_count bool (fun k b => if b then f k else false) P true n P1 step _ erefl.
rewrite /all_upto => all_n k k_le; apply: Pn all_n _ _.
by lia.
Qed.

Lemma collect_upto_ind (A : Type) (P : A -> Prop) n (f : positive -> A -> A) a :
    P a -> (forall k x, (k <= n)%positive -> P x -> P (f k x)) -> P (collect_upto n f a).
Proof. by move=> Pa step; have [] := @iter_count A f (fun _ => P) a n Pa step _ erefl. Qed.

(* A search finds only what has every property that the seeds have and steps keep. *)
Section Search.

Variable P : positive -> Prop.
Variable steps : positive -> list positive.
Hypothesis closed : forall p, P p -> forall q, List.In q (steps p) -> P q.

Let ok (st : list positive * seen_set) :=
  (forall p, List.In p st.1 -> P p) /\ (forall p, M.mem p st.2 -> P p).

Lemma visit_ok st p : ok st -> P p -> ok (visit st p).
Proof.
case=> in_stack in_seen Pp; rewrite /visit; case: ifP => _ //; split=> q /=.
  by case=> [<-|/in_stack].
rewrite M.mem_find; have [->|neq] : q = p \/ q <> p by lia.
  by [].
by rewrite M.gso // -M.mem_find => /in_seen.
Qed.

Lemma visits_ok l st : ok st -> (forall p, List.In p l -> P p) ->
  ok (List.fold_left visit l st).
Proof.
elim: l st => [|p l IHl] st okst Pl //=; apply: IHl => [|q ql]; last by apply: Pl; right.
by apply: visit_ok => //; apply: Pl; left.
Qed.

Lemma search_sound seeds n :
  (forall p, List.In p seeds -> P p) -> forall p, M.mem p (search steps seeds n) -> P p.
Proof.
move=> Pseeds; suff [] : ok (Pos.iter (search_step steps)
    (List.fold_left visit seeds (nil, M.empty unit)) n) by [].
apply: Pos.iter_invariant => [st okst|]; last first.
  by apply: visits_ok => //; split=> p //; rewrite M.mem_find M.gempty.
rewrite /search_step; case: st okst => [[|p rest] seen] //= [in_stack in_seen].
apply: visits_ok => [|q]; last by apply: closed; apply: in_stack; left.
by split=> q; [move=> ql; apply: in_stack; right | exact: in_seen].
Qed.

End Search.

(* Darts of a table with n edges, and their numbers *)
Section TableDarts.

Variables (n m : positive).

Definition table_darts : finType := [finType of bool * 'I_(Pos.to_nat n)].
Definition table_vertices : finType := [finType of 'I_(Pos.to_nat m)].
Implicit Types (x y : table_darts) (w : table_vertices).

Definition dart_name x : positive :=
  let e := Pos.of_succ_nat x.2 in if x.1 then xI e else xO e.
Definition vertex_name w : positive := Pos.of_succ_nat w.

Lemma dart_name_inj : injective dart_name.
Proof.
move=> [b e] [b' e']; rewrite /dart_name /=.
by case: b b' => [] [] //= [] /SuccNat2Pos.inj /val_inj ->.
Qed.

Lemma vertex_name_inj : injective vertex_name.
Proof. by move=> w w' /SuccNat2Pos.inj /val_inj. Qed.

Definition dart_twin x : table_darts := (~~ x.1, x.2).

Lemma dart_twinK : involutive dart_twin.
Proof. by case=> b e; rewrite /dart_twin /= negbK. Qed.

Lemma twin_dart_name x : twin_dart (dart_name x) = dart_name (dart_twin x).
Proof. by case: x => [[] e]. Qed.

Lemma small_number k e : (e <= k)%positive -> exists i : 'I_(Pos.to_nat k), Pos.of_succ_nat i = e.
Proof.
move=> le_e; have lt : Nat.pred (Pos.to_nat e) < Pos.to_nat k by apply/ltP; lia.
exists (Ordinal lt) => /=; apply: Pos2Nat.inj; rewrite SuccNat2Pos.id_succ; lia.
Qed.

Lemma dart_in_name p : dart_in n p -> exists x, p = dart_name x.
Proof.
case: p => [e|e|] //= /Pos.leb_le /small_number[i <-].
  by exists (true, i).
by exists (false, i).
Qed.

Lemma vertex_in_name o : Pos.leb o m -> exists w, o = vertex_name w.
Proof. by move=> /Pos.leb_le /small_number[i <-]; exists i. Qed.

Lemma all_darts_name f x : all_darts n f -> f (dart_name x).
Proof.
case: x => b e /all_upto_count all_e; have e_le : (Pos.of_succ_nat e <= n)%positive.
  by have /ltP := ltn_ord e; lia.
by have /andP[f0 f1] := all_e _ e_le; rewrite /dart_name; case: b.
Qed.

End TableDarts.

Lemma porbit_next (T : finType) (p : {perm T}) x y : y \in porbit p x -> p y \in porbit p x.
Proof. by case/porbitP=> i ->; rewrite -permM -expgSr mem_porbit. Qed.

(* The audit of one halfedge after the other makes a surface of the table. *)
Section Audit.

Variables (n m : positive) (tb : table).
Let D := table_darts n.
Let V := table_vertices m.
Implicit Types (x y : D).

Lemma audit_surface : all_darts n (dart_ok m n tb) ->
  exists s : surface D V,
    [/\ represents (@dart_name n) (@vertex_name m) s tb, loopless s,
        forall x, next s (next s (next s x)) = x,
        forall x, twin s x = dart_twin x
      & forall x, origin s (twin s x) = origin s (next s x)].
Proof.
move=> ok_all; have ok x := all_darts_name x ok_all.
have /fin_all_exists[rec get_rec] : forall x, exists r : D * V,
    get (dart_name x) tb = Some (dart_name r.1, vertex_name r.2).
  move=> x; have := ok x; rewrite /dart_ok; case: (get _ _) => [[p o]|] //.
  by case/andP=> /andP[/dart_in_name[y ->] /vertex_in_name[w ->]] _; exists (y, w).
pose nx x := (rec x).1; pose og x := (rec x).2.
have {}get_rec x : get (dart_name x) tb = Some (dart_name (nx x), vertex_name (og x)).
  exact: get_rec.
have facts x : [/\ og (dart_twin x) = og (nx x), og x != og (nx x) & nx (nx (nx x)) = x].
  have := ok x; rewrite /dart_ok get_rec twin_dart_name !get_rec => /andP[_].
  case/andP=> /andP[/Pos.eqb_eq/vertex_name_inj-> /negP ne] /Pos.eqb_eq/dart_name_inj->.
  by split=> //; apply/negP => /eqP eq_o; apply: ne; rewrite eq_o Pos.eqb_refl.
have nx_inj : injective nx.
  by move=> x y eq_n; have [_ _ <-] := facts x; rewrite eq_n; case: (facts y).
exists (Surface (perm (inv_inj (@dart_twinK n))) (perm nx_inj) [ffun x => og x]).
split=> [|x|x|x|x]; rewrite /= ?ffunE ?permE; try by case: (facts x).
by split=> x; rewrite /= ?permE ?ffunE ?twin_dart_name.
Qed.

(* What the audit found of the whole table. *)
Section Found.

Variable s : surface D V.
Hypothesis rep : represents (@dart_name n) (@vertex_name m) s tb.
Hypothesis noloop : loopless s.
Hypothesis n3 : forall x, next s (next s (next s x)) = x.
Hypothesis tw : forall x, twin s x = dart_twin x.
Hypothesis runs_back : forall x, origin s (twin s x) = origin s (next s x).

Let get_rep x : get (dart_name x) tb = Some (dart_name (next s x), vertex_name (origin s x)).
Proof. by case: rep. Qed.

Let twin_name x : twin_dart (dart_name x) = dart_name (twin s x).
Proof. by case: rep. Qed.

Let tw_tw : involutive (twin s).
Proof. by move=> x; rewrite !tw dart_twinK. Qed.

Let origin_sigma x : origin s (sigma s x) = origin s x.
Proof. by rewrite sigmaE -runs_back tw_tw. Qed.

Let reps := representatives n tb.

Lemma representatives_sound k p : M.find k reps = Some p ->
  exists x : D, p = dart_name x /\ k = vertex_name (origin s x).
Proof.
pose sound mp := forall k p, M.find k mp = Some p ->
  exists x : D, p = dart_name x /\ k = vertex_name (origin s x).
have note x mp : sound mp -> sound (note_origin tb (dart_name x) mp).
  move=> sound_mp k' p'; rewrite /note_origin get_rep.
  have [->|neq] : k' = vertex_name (origin s x) \/ k' <> vertex_name (origin s x) by lia.
    by rewrite M.gss => -[<-]; exists x.
  by rewrite M.gso // => /sound_mp.
suff: sound reps by apply.
apply: collect_upto_ind => [k' p'|e mp /small_number[i <-] sound_mp].
  by rewrite M.gempty.
exact: (note (false, i) _ (note (true, i) _ sound_mp)).
Qed.

Lemma seeds_sound p : List.In p (seeds_of m reps) ->
  exists x : D, p = dart_name x /\ M.find (vertex_name (origin s x)) reps = Some (dart_name x).
Proof.
pose sound l := forall p, List.In p l ->
  exists x : D, p = dart_name x /\ M.find (vertex_name (origin s x)) reps = Some (dart_name x).
suff: sound (seeds_of m reps) by apply.
apply: (@collect_upto_ind _ sound) => [//|k l _ sound_l].
case found: (M.find k reps) => [q|] // r /= [<-|/sound_l //].
by have [x [def_q def_k]] := representatives_sound found; exists x; rewrite -def_k -def_q.
Qed.

(* Each dart lies in the orbit of the representative of its vertex. *)
Lemma orbits_found : vertices_ok m n tb -> forall y, exists x,
  M.find (vertex_name (origin s y)) reps = Some (dart_name x) /\ y \in porbit (sigma s) x.
Proof.
case/andP=> _ seen y; pose P p := exists y x : D,
  [/\ p = dart_name y, M.find (vertex_name (origin s x)) reps = Some (dart_name x)
    & y \in porbit (sigma s) x].
have [z [x [/dart_name_inj<- found yx]]] : P (dart_name y).
  apply: search_sound (all_darts_name y seen) => [p [z [x [-> found zx]]] q|p /seeds_sound].
    rewrite /sigma_steps twin_name get_rep => /= -[<-|//].
    exists (next s (twin s z)), x; split=> //.
    by rewrite -sigmaE; apply: porbit_next.
  by case=> x [-> found]; exists x, x; split; rewrite // porbit_id.
exists x; split=> //; rewrite (porbit_invariant origin_sigma yx) //.
Qed.

Lemma found_well_formed : vertices_ok m n tb -> well_formed s.
Proof.
move=> ok; have rep_orbit := orbits_found ok; split=> // [x|x|x y|w].
- by rewrite tw /dart_twin; case: x => [[] e]; apply/eqP => -[].
- by apply: contra (noloop x) => /eqP->.
- apply/eqP/idP => [eq_o|/(porbit_invariant origin_sigma) //].
  have [rx [found_x x_orb]] := rep_orbit x; have [ry [found_y y_orb]] := rep_orbit y.
  move: found_y; rewrite -eq_o found_x => -[/dart_name_inj eq_r].
  move: x_orb y_orb; rewrite -eq_r -!eq_porbit_mem => /eqP-> /eqP->.
  exact: eqxx.
case/andP: ok => /all_upto_count used _.
have w_le : (vertex_name w <= m)%positive by have /ltP := ltn_ord w; rewrite /vertex_name; lia.
have := used _ w_le; rewrite M.mem_find.
case found: (M.find _ _) => [p|] // _.
have [x [_ /vertex_name_inj->]] := representatives_sound found.
by exists x.
Qed.

Lemma found_connected : well_formed s -> connected_ok n tb -> connected s.
Proof.
move=> wf seen; have n_pos : 0 < Pos.to_nat n by apply/ltP; lia.
pose x0 : D := (false, Ordinal n_pos).
have from_x0 y : connect (link s) x0 y.
  pose P p := exists y : D, p = dart_name y /\ connect (link s) x0 y.
  have [z [/dart_name_inj<- //]] : P (dart_name y).
  apply: search_sound (all_darts_name y seen) => [p [z [-> to_z]] q|p /= [<-|//]].
    rewrite /link_steps get_rep twin_name => /= -[<-|[<-|//]].
      exists (twin s z); split=> //; apply: connect_trans to_z (connect1 _).
      by rewrite /link eqxx.
    exists (next s z); split=> //; apply: connect_trans to_z (connect1 _).
    by rewrite /link eqxx orbT.
  by exists x0.
by move=> x y; apply: connect_trans (from_x0 y); rewrite link_sym.
Qed.

End Found.

(* A table that passes the audit represents a surface of the allowed kind and of that genus. *)
Theorem audit_sound f g : audit m n tb = Some (f, g) -> exists s : surface D V,
  [/\ represents (@dart_name n) (@vertex_name m) s tb, good s,
      faces s = N.to_nat f & has_genus s (N.to_nat g)].
Proof.
rewrite /audit; case: ifP => [/andP[/andP[darts_ok vert_ok] conn_ok]|//].
case: ifP => [/N.eqb_eq|//]; set f0 := (_ / 3)%num; set g0 := (_ / 2)%num => euler_eq [<- <-].
have [s [rep noloop n3 tw back]] := audit_surface darts_ok.
have wf := found_well_formed rep noloop n3 tw back vert_ok.
have con := found_connected rep wf conn_ok.
have cardD : #|D| = 2 * Pos.to_nat n by rewrite card_prod card_bool card_ord.
have faces_eq : faces s * 3 = 2 * Pos.to_nat n by rewrite faces3.
have edges_eq : edges s * 2 = 2 * Pos.to_nat n by rewrite edges2.
have verts_eq : vertices s = Pos.to_nat m by rewrite vertices_labels // card_ord.
have f0_eq : faces s = N.to_nat f0.
  have def_f0 : f0 = (N.of_nat (faces s) * 3 / 3)%num.
    by congr (_ / _)%num; move: faces_eq; rewrite -!multE; lia.
  by rewrite def_f0 N.div_mul // Nat2N.id.
exists s; split=> //; split=> //; rewrite verts_eq f0_eq; move: edges_eq euler_eq.
by rewrite -!multE -!plusE; lia.
Qed.

End Audit.

(* Certificates *)
Section Certificates.

Variables (n m : positive).
Let D := table_darts n.
Let V := table_vertices m.
Implicit Types (s : surface D V) (tb : table).

Definition table_of s tb := represents (@dart_name n) (@vertex_name m) s tb.

(* Following a log is a chain of allowed flips, one for each entry. *)
Theorem replay_sound log s tb tb' rest : well_formed s -> table_of s tb ->
  replay n log tb = (Done tb', rest) ->
  exists s', reach_in s (size log) s' /\ table_of s' tb'.
Proof.
elim: log s tb => [|e log IHlog] s tb wf rep /=.
  by case=> <- _; exists s; split=> //; apply: reach_in0.
case: ifP => // /Pos.leb_le /small_number[i def_e].
have := flip_table_refines (@dart_name_inj n) (@vertex_name_inj m) (false, i) wf rep.
rewrite /dart_name /= def_e; case: ifP => [ok [tb1 [-> rep1 _]]|_ ->] // followed.
have wf1 := flip_well_formed wf (allowed_apart wf ok).
have [s' [r rep']] := IHlog _ _ wf1 rep1 followed.
by exists s'; split=> //; apply: reach_inS ok r.
Qed.

(* A correspondence that passes makes the same labelled surface of both. *)
Theorem same_by_sound mp s s' tb tb' : well_formed s -> connected s' ->
  table_of s tb -> table_of s' tb' -> same_by n mp tb tb' -> same_surface s s'.
Proof.
move=> wf con [tw rep] [tw' rep'] ok_all; have ok x := all_darts_name x ok_all.
have /fin_all_exists[f find_f] : forall x : D, exists y : D,
    M.find (dart_name x) mp = Some (dart_name y).
  move=> x; have := ok x; rewrite /same_at; case: (M.find _ _) => [q|] //.
  by case/andP=> /dart_in_name[y ->] _; exists y.
have facts x : [/\ origin s' (f x) = origin s x, f (twin s x) = twin s' (f x)
                 & f (next s x) = next s' (f x)].
  have := ok x; rewrite /same_at find_f rep rep' tw tw' !find_f => /andP[_].
  case/andP=> /andP[/Pos.eqb_eq/vertex_name_inj-> /Pos.eqb_eq/dart_name_inj->].
  by move=> /Pos.eqb_eq/dart_name_inj->.
have onto : forall y, exists x, f x == y.
  have n_pos : 0 < Pos.to_nat n by apply/ltP; lia.
  move=> y; apply/existsP; move: y.
  apply: (@connected_all _ _ s' con (fun y => [exists x, f x == y]) (f (false, Ordinal n_pos))).
  - by apply/existsP; exists (false, Ordinal n_pos).
  - move=> y /existsP[x /eqP<-]; apply/existsP; exists (twin s x).
    by case: (facts x) => _ -> _.
  - move=> y /existsP[x /eqP<-]; apply/existsP; exists (next s x).
    by case: (facts x) => _ _ ->.
have gK : cancel (fun y => xchoose (onto y)) f by move=> y; apply/eqP/(xchooseP (onto y)).
exists f; split=> [|x|x|x]; try by case: (facts x).
by apply: (bij_can_bij _ gK); apply: injF_bij; apply: can_inj gK.
Qed.

(* What a certificate that passes certifies. *)
Theorem certificate_sound a m1 start log m2 b : certificate_ok m n a m1 start log m2 b ->
  exists sa s0 s1 sb : surface D V,
    [/\ table_of sa a /\ good sa, table_of sb b /\ good sb, table_of s0 start /\ same_surface sa s0,
        reach_in s0 (size log) s1 & same_surface s1 sb].
Proof.
rewrite /certificate_ok; case audit_a: (audit m n a) => [[fa ga]|] //.
case audit_0: (audit m n start) => [[f0 g0]|] //.
case audit_b: (audit m n b) => [[fb gb]|] // /andP[same_a].
case followed: (replay n log start) => [[tb1||] rest] // same_b.
have [sa [rep_a good_a _ _]] := audit_sound audit_a.
have [s0 [rep_0 good_0 _ _]] := audit_sound audit_0.
have [sb [rep_b good_b _ _]] := audit_sound audit_b.
have [s1 [r rep_1]] := replay_sound (good_wf good_0) rep_0 followed.
exists sa, s0, s1, sb; split=> //; first split=> //.
  exact: same_by_sound (good_wf good_a) (good_connected good_0) rep_a rep_0 same_a.
have good_1 := reach_in_good r good_0.
exact: same_by_sound (good_wf good_1) (good_connected good_b) rep_1 rep_b same_b.
Qed.

End Certificates.

(* Tables that are equal entry by entry represent the same surfaces. *)
Theorem same_table_sound n (V : finType) (v : V -> positive)
    (s : surface (table_darts n) V) tb tb' :
  represents (@dart_name n) v s tb -> same_table n tb tb' -> represents (@dart_name n) v s tb'.
Proof.
move=> [tw rep] ok_all; split=> // x; have := all_darts_name x ok_all.
rewrite rep; case: (get _ tb') => [[y o]|] // /andP[].
by move=> /Pos.eqb_eq-> /Pos.eqb_eq->.
Qed.

(* Extraction of the programs of tables.v to OCaml, into checker.ml.

   Nothing is replaced by hand-written OCaml: numbers stay binary lists of digits.  bool, list,
   option and pairs become OCaml's own, which have the same constructors. *)

From Coq Require Import Extraction ExtrOcamlBasic PArith NArith.
From Tightflip Require Import tables.

Extraction "checker.ml" flip_table unflip_table audit replay same_by same_table certificate_ok get
  twin_dart M.add M.empty.

(* The statements that are claimed, and what they rest on.

   For each theorem Coq prints the statement as it understands it and the axioms behind it;
   scripts/proof looks that there are none. *)

From mathcomp Require Import all_ssreflect all_fingroup ssralg ssrint.
From Tightflip Require surface flip invariants order genus reach hub slide star book equal_books.
From Tightflip Require patch sorting connected higher_genus every_genus signed orientability.
From Tightflip Require oriented non_orientable tables refinement audit_complete.
From Tightflip Require contour rehang merging short_paths.

(* Theorem 4.2. *)
Check invariants.theorem_4_2.
Print Assumptions invariants.theorem_4_2.
Check invariants.theorem_4_2_guard.
Print Assumptions invariants.theorem_4_2_guard.
Check order.theorem_4_2_local.
Print Assumptions order.theorem_4_2_local.
Check invariants.many_vertices_three_neighbour.
Print Assumptions invariants.many_vertices_three_neighbour.
Check order.flip_twice.
Print Assumptions order.flip_twice.
Check order.flip_order_four.
Print Assumptions order.flip_order_four.
Check invariants.flipK.
Print Assumptions invariants.flipK.
Check order.unflipK.
Print Assumptions order.unflipK.
Check order.unflip_flip3.
Print Assumptions order.unflip_flip3.
Check flip.flip_other_side.
Print Assumptions flip.flip_other_side.

(* Every connected surface has a genus. *)
Check genus.euler_inequality.
Print Assumptions genus.euler_inequality.
Check genus.euler_even.
Print Assumptions genus.euler_even.
Check genus.connected_has_genus.
Print Assumptions genus.connected_has_genus.

(* Orientability. *)
Check orientability.theorem_4_2_signed.
Print Assumptions orientability.theorem_4_2_signed.
Check orientability.signed_flip_well_formed.
Print Assumptions orientability.signed_flip_well_formed.
Check orientability.signed_flip_orientable.
Print Assumptions orientability.signed_flip_orientable.
Check orientability.signed_flip_guard.
Print Assumptions orientability.signed_flip_guard.
Check orientability.signed_three_neighbour.
Print Assumptions orientability.signed_three_neighbour.
Check signed.around_out.
Print Assumptions signed.around_out.
Check signed.turn_over_well_formed.
Print Assumptions signed.turn_over_well_formed.
Check signed.turn_over_orientable.
Print Assumptions signed.turn_over_orientable.
Check oriented.unsigned_well_formed.
Print Assumptions oriented.unsigned_well_formed.
Check oriented.unsigned_flip.
Print Assumptions oriented.unsigned_flip.
Check oriented.orientable_turned.
Print Assumptions oriented.orientable_turned.
Check non_orientable.signed_reach_not_orientable.
Print Assumptions non_orientable.signed_reach_not_orientable.
Check non_orientable.projective_plane_not_orientable.
Print Assumptions non_orientable.projective_plane_not_orientable.
Check non_orientable.projective_plane_flip.
Print Assumptions non_orientable.projective_plane_flip.
Check non_orientable.klein_bottle_not_orientable.
Print Assumptions non_orientable.klein_bottle_not_orientable.
Check non_orientable.klein_bottle_flip.
Print Assumptions non_orientable.klein_bottle_flip.

(* Theorem 4.3, step by step. *)
Check hub.hub_step.
Print Assumptions hub.hub_step.
Check hub.gather.
Print Assumptions hub.gather.
Check hub.gather_least.
Print Assumptions hub.gather_least.
Check hub.gather_sphere.
Print Assumptions hub.gather_sphere.
Check slide.slide.
Print Assumptions slide.slide.
Check slide.slide_degree.
Print Assumptions slide.slide_degree.
Check star.star_at_hub.
Print Assumptions star.star_at_hub.
Check star.star.
Print Assumptions star.star.
Check star.book_pages.
Print Assumptions star.book_pages.
Check star.star_sphere.
Print Assumptions star.star_sphere.
Check book.page_order_exists.
Print Assumptions book.page_order_exists.
Check sorting.exchange.
Print Assumptions sorting.exchange.
Check sorting.sort.
Print Assumptions sorting.sort.
Check equal_books.equal_books.
Print Assumptions equal_books.equal_books.
Check equal_books.equal_books_order.
Print Assumptions equal_books.equal_books_order.

(* Theorem 4.3. *)
Check connected.flip_same_surface.
Print Assumptions connected.flip_same_surface.
Check connected.reach_in_back.
Print Assumptions connected.reach_in_back.
Check connected.reach_sym.
Print Assumptions connected.reach_sym.
Check connected.joined_sym.
Print Assumptions connected.joined_sym.
Check connected.joined_trans.
Print Assumptions connected.joined_trans.
Check connected.theorem_4_3_in.
Print Assumptions connected.theorem_4_3_in.
Check connected.theorem_4_3.
Print Assumptions connected.theorem_4_3.
Check connected.theorem_4_3_same_darts.
Print Assumptions connected.theorem_4_3_same_darts.
Check contour.equal_contours.
Print Assumptions contour.equal_contours.
Check rehang.hang_back.
Print Assumptions rehang.hang_back.
Check rehang.hang_on.
Print Assumptions rehang.hang_on.
Check merging.merge_legs.
Print Assumptions merging.merge_legs.
Check merging.sort_legs.
Print Assumptions merging.sort_legs.
Check merging.chain_legs.
Print Assumptions merging.chain_legs.
Check short_paths.book_contour.
Print Assumptions short_paths.book_contour.
Check short_paths.theorem_4_3_short.
Print Assumptions short_paths.theorem_4_3_short.

(* Beyond the sphere. *)
Check higher_genus.three_vertices_no_flip.
Print Assumptions higher_genus.three_vertices_no_flip.
Check higher_genus.three_vertices_alone.
Print Assumptions higher_genus.three_vertices_alone.
Check higher_genus.genus_2_not_joined.
Print Assumptions higher_genus.genus_2_not_joined.
Check higher_genus.genus_3_not_joined.
Print Assumptions higher_genus.genus_3_not_joined.
Check every_genus.higher_genus_not_joined.
Print Assumptions every_genus.higher_genus_not_joined.

(* The programs that are extracted. *)
Check refinement.flip_table_refines.
Print Assumptions refinement.flip_table_refines.
Check refinement.unflip_table_refines.
Print Assumptions refinement.unflip_table_refines.
Check refinement.audit_sound.
Print Assumptions refinement.audit_sound.
Check refinement.replay_sound.
Print Assumptions refinement.replay_sound.
Check refinement.same_by_sound.
Print Assumptions refinement.same_by_sound.
Check refinement.certificate_sound.
Print Assumptions refinement.certificate_sound.
Check refinement.same_table_sound.
Print Assumptions refinement.same_table_sound.
Check audit_complete.audit_complete.
Print Assumptions audit_complete.audit_complete.
Check audit_complete.audit_exact.
Print Assumptions audit_complete.audit_exact.

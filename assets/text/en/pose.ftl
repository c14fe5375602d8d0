### What stands in the way of the tool.

beam_hits_facet = the beam hits facet { $facet }
head_hits_facet = the head hits facet { $facet }
beam_hits_clamp = the beam hits clamp { $clamp }
head_hits_clamp = the head hits clamp { $clamp }
beam_in_unscanned = the beam would go through what was not scanned
head_in_unscanned = the head would stand in what was not scanned
abrasive_hits_facet = the grinding tool comes too close to facet { $facet }
abrasive_hits_clamp = the grinding tool comes too close to clamp { $clamp }
abrasive_in_unscanned = the grinding tool would stand in what was not scanned
abrasive_gouges_facet = the grinding tool touches beside its contact: it would cut into facet { $facet }

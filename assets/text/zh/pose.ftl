### 什么挡住了工具。

beam_hits_facet = 光束碰到面片 { $facet }
head_hits_facet = 激光头碰到面片 { $facet }
beam_hits_clamp = 光束碰到夹具 { $clamp }
head_hits_clamp = 激光头碰到夹具 { $clamp }
beam_in_unscanned = 光束会穿过未扫描的区域
head_in_unscanned = 激光头会处于未扫描的区域
abrasive_hits_facet = 打磨工具离面片 { $facet } 太近
abrasive_hits_clamp = 打磨工具离夹具 { $clamp } 太近
abrasive_in_unscanned = 打磨工具会处于未扫描的区域
abrasive_gouges_facet = 打磨工具在接触处之外也碰到零件：会过切面片 { $facet }

### 三维视图及其显示内容。

## 视图
view_name = 三维视图
view_cube = 视图立方体
view_front = 前
view_back = 后
view_left = 左
view_right = 右
view_top = 上
view_bottom = 下

## 无法显示的原因
view_no_headless_gl = 没有屏幕，无法使用 OpenGL（{ $reason }）：请安装 libegl1 libgl1-mesa-dri（Debian、Ubuntu）或 mesa-libEGL mesa-dri-drivers（Fedora）
view_egl_not_on_macos = macOS 没有 EGL
view_egl_failed = EGL：{ $answer }
view_egl_no_device = EGL 找不到设备
view_unnamed_device = 设备
view_device_answers = { $device }：{ $answer }
view_too_old = 没有 OpenGL 3.3：驱动程序在 { $renderer } 上提供的是 { $version }；请更新显卡驱动程序，或安装 libegl1 libgl1-mesa-dri 并以 LIBGL_ALWAYS_SOFTWARE=1 启动
view_driver_refuses = 显卡驱动程序拒绝创建{ $what }：{ $reason }；请更新驱动程序，或以 LIBGL_ALWAYS_SOFTWARE=1 启动
view_framebuffer_refused = 显卡驱动程序无法绘制 { $width } × { $height } 像素的图像（状态 { $status }）；请更新驱动程序，或以 LIBGL_ALWAYS_SOFTWARE=1 启动
view_vertex_array = 顶点数组
view_framebuffer = 帧缓冲区
view_background_shader = 背景着色器
view_facet_shader = 面片着色器
view_line_shader = 线条着色器
view_dot_shader = 点着色器
view_cloud_shader = 扫描数据着色器

## 图例
legend_over = 过量
legend_under = 不足
legend_shaded = 遮挡
legend_no_light = 无光照
legend_surplus = 多余
legend_within = 公差内
legend_missing = 缺损
legend_not_scanned = 未扫描
legend_spacing = { $mm } mm
legend_spacing_share = { $percent } %

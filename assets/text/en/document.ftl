### document

laser_beam_blocked = { $cell }: bodies.obstacles: { $obstacle } stands in the way of the beam, which stands still; move one of them
laser_head_blocked = { $cell }: bodies.obstacles: { $obstacle } stands in the way of the head, which stands still; move one of them

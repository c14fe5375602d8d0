pub fn area_times(){}

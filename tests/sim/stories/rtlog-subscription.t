A component that may send more than 1,000 values a second does not call rtlog in its own cycle, others do; all leave no connector.

world: senders 100 8
world: senders 2000 8 --context fast.host_cxt/%n.rtc

  $ rtlog -q -f a.mcap /robot &
  $ sleep 1
  $ rtcat --json Source0.rtc:number
  {.*"dataport.subscription_type": "flush".*} (re)
  $ rtcat --json ../fast.host_cxt/Source0.rtc:number
  {.*"dataport.subscription_type": "new".*} (re)
  $ strike TERM rtlog
  $ wait rtlog
  [143] after 1.0 s
  $ ctl @senders connectors Source0:number
  $ ctl @senders2 connectors Source0:number

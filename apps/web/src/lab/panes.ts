/** A pane of the lab. */
export type PaneName = 'program' | 'world' | 'network'

/** Where a child has dragged the borders of the panes, as shares 0..1 of the lab, for each arrangement of panes. */
export interface PaneSizes {
  readonly columns?: readonly [program: number, world: number]
  readonly stacked?: readonly [program: number, world: number]
  readonly rows?: readonly [world: number, upper: number]
}

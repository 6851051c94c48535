import { layOutWorld, shortestPath } from '@botgarten/learning/q-learning'
import { readMap } from '@botgarten/maps'
import { endsOf, setRoom, writeMap, type RoomKind } from '@botgarten/maps/own'
import type { RoomMap } from '@botgarten/programs'
import { DrawnMap } from './drawn.svelte.ts'
import type { OpenedDrawing } from './projects.ts'

/** A world of rooms being made. */
export class RoomDesigner extends DrawnMap<RoomMap> {
  tool = $state<RoomKind>('wall')
  /** The room that keys are on. */
  at = $state(0)
  /** The room that could not be changed: the start, or the last treasure. */
  refused = $state<number | null>(null)

  constructor(opened: OpenedDrawing) {
    super(opened, opened.project.maps![opened.mapId] as RoomMap)
  }

  get map() {
    return this.settled
  }
  get columns() {
    return this.settled.rows[0]!.length
  }

  readonly ends = $derived(endsOf(this.settled))

  /** Moves of the shortest way, where nothing slides; null: there is none. */
  readonly moves = $derived.by(() => {
    const { map, start, goal } = readMap(writeMap(this.settled, 'tried')).map!
    const rooms = shortestPath(layOutWorld({ map, start: start!, goal: goal! }))
    return rooms === null ? null : rooms - 1
  })

  /** What the tool makes of a room. */
  tap(room: number): void {
    this.at = room
    const next = setRoom(this.settled, room, this.tool)
    this.refused = next === this.settled ? room : null
    this.change(next)
  }

  protected override changed({ rows }: RoomMap): void {
    this.at = Math.min(this.at, rows.join('').length - 1)
  }
}

import type { Course } from '@botgarten/learning/q-learning'
import type { View } from '@botgarten/lab'
import { liesOn, placeOf, wayFault } from '@botgarten/maps'
import type { LearningOutline } from '@botgarten/programs'
import { TICKS_PER_SECOND, type Pose } from '@botgarten/simulation'
import type { LabSession } from '#lab/session.svelte.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { Stage } from '#figures/map/stage.ts'
import { WayOnFloor } from './way-on-floor.ts'

/** A learning that has ended with a way. */
export interface LearnedWay {
  readonly course: Course
  readonly stage: Stage
  readonly stations: readonly number[]
  readonly blocks: LearningOutline['blocks']
}

/** The drive ends within `near` cm of the goal (as in the check `arrives`) after `patience` ticks with both wheels at 0. */
const [near, patience] = [6, 2 * TICKS_PER_SECOND]

/** After learning: draws the way on the floor and lets Bo drive it. */
export class Drive {
  readonly #session: LabSession
  readonly #ui: LabUi
  readonly #floor: WayOnFloor
  readonly #learned: () => LearnedWay | null
  /** Shown large in the middle; the other one is shown small next to it. */
  front = $state<'map' | 'floor'>('map')

  /** Tick since which Bo stands at the goal; null: it does not. */
  #arrived: number | null = null

  /** @param learned returns the learned way, or null while there is none */
  constructor(session: LabSession, ui: LabUi, learned: () => LearnedWay | null) {
    this.#session = session
    this.#ui = ui
    this.#floor = new WayOnFloor(session)
    this.#learned = learned
  }

  /** Draws the way if the program has the block that draws; then, with `drives` and the block that drives, starts Bo. */
  async draw(drives: boolean): Promise<void> {
    const learned = this.#learned()
    if (learned?.blocks.draw === undefined || learned.stations.length < 2) return
    const { course, stage, stations, blocks } = learned
    if (wayFault(stage.map, stations) !== null) return
    // While the way is drawn the user may start another learning, or Bo.
    const stands = () => this.#learned()?.course === course && this.#session.lab.view.phase !== 'running'
    await this.#floor.lay(stage, stations, stands)
    if (stands() && drives && blocks.drive !== undefined) this.#ui.start()
  }

  /** If the way is not drawn yet, draws it and then starts Bo. Returns false if nothing has to be drawn. */
  drawFirst(): boolean {
    const learned = this.#learned()
    if (learned?.blocks.draw === undefined || learned.stations.length < 2) return false
    if (wayFault(learned.stage.map, learned.stations) !== null) return false
    if (this.#floor.lies(learned.stage, learned.stations)) return false
    void this.draw(true)
    return true
  }

  /** Start pose of the way on the floor; null if no learned way is drawn there. */
  get starts(): readonly Pose[] | null {
    const learned = this.#learned()
    if (!learned || !this.#floor.lies(learned.stage, learned.stations)) return null
    return this.#floor.starts(learned.stage, learned.stations)
  }

  /** Shows a pale picture of the map below its drawn way: the floor is recognised as that map. */
  showMap(stage: Stage | null): void {
    const { world } = this.#session.lab.document
    const lies = stage && liesOn(stage.map, world)
    const stations = stage?.map.stations.map((_, station) => placeOf(stage.map, station)) ?? []
    this.#session.below = lies ? { url: stage.picture.pale, stations } : null
  }

  /** Bo drives: shows the floor large; on a phone, which shows one part at a time, turns to the world. */
  comeForward(): void {
    this.front = 'floor'
    if (this.#ui.page === 'network') this.#ui.page = 'world'
  }

  /**
   * Ends the drive once Bo has not moved at the goal for two seconds: the program that follows the line has no end.
   * @param view of a lab that runs
   */
  endAtGoal({ tick, robots: [bo] }: Pick<View, 'tick' | 'robots'>): void {
    if (!bo || !this.#isAtGoal(bo)) this.#arrived = null
    else if (this.#arrived === null || this.#arrived > tick) this.#arrived = tick
    else if (tick - this.#arrived >= patience) this.#session.lab.stop()
  }

  #isAtGoal({ pose, motors }: View['robots'][number]): boolean {
    if (Object.values(motors).some((percent) => percent !== 0)) return false
    const learned = this.#learned()
    const goal = learned?.stations.at(-1)
    if (!learned || goal === undefined || !this.#floor.lies(learned.stage, learned.stations)) return false
    const { x, y } = placeOf(learned.stage.map, goal)
    return Math.hypot(pose.x - x, pose.y - y) <= near
  }

  swap(): void {
    this.front = this.front === 'map' ? 'floor' : 'map'
  }

  start(): void {
    this.#ui.start()
  }
}

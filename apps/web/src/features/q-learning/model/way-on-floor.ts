import { drawWay } from '@botgarten/maps'
import type { Scene } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import type { LabSession } from '#lab/session.svelte.ts'
import { Floors } from '#lab/floor/floors.ts'
import type { Stage } from '#figures/map/stage.ts'
import { nextFrame } from './clock.ts'

/** Draws the learned way as lines on the floor of the robot's world. */
export class WayOnFloor {
  readonly #session: LabSession
  readonly #floors = new Floors()

  constructor(session: LabSession) {
    this.#session = session
  }

  /** Is this way drawn on the floor already? */
  lies = (stage: Stage, stations: readonly number[]): boolean =>
    stations.length > 1 && this.#isThere(drawWay(stage.map, stations).scene)

  /** Start poses of the robot on this way. */
  starts = (stage: Stage, stations: readonly number[]): readonly Pose[] =>
    drawWay(stage.map, stations).scene.starts

  #isThere({ lines }: Scene): boolean {
    return JSON.stringify(this.#session.lab.document.world.lines) === JSON.stringify(lines)
  }

  /**
   * Draws the way and places the robot on its start. Waits for a frame before each costly step, so that the screen shows the
   * end of learning first.
   * @param wanted asked after the waits: false if the user has started something else or closed the playground by then
   */
  async lay(stage: Stage, stations: readonly number[], wanted: () => boolean): Promise<void> {
    const session = this.#session
    await nextFrame()
    const { scene } = drawWay(stage.map, stations)
    if (this.#isThere(scene)) {
      if (wanted()) session.toStart()
      return
    }
    await nextFrame()
    await this.#floors.load(session.lab.document.world, session.pictures)
    const floor = this.#floors.paint(scene)
    await nextFrame()
    if (!wanted()) return
    session.paint = () => floor
    session.apply({ kind: 'scene', after: scene })
    session.paint = this.#floors.paint
    await nextFrame()
  }
}

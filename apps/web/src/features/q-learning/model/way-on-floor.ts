import { drawWay } from '@botgarten/maps'
import type { Scene } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import type { LabSession } from '#lab/session.svelte.ts'
import { Floors } from '#lab/floor/floors.ts'
import type { Stage } from '#figures/map/stage.ts'
import { nextFrame } from './clock.ts'

/** The way as the floor of the robot's world. */
export class WayOnFloor {
  readonly #session: LabSession
  readonly #floors = new Floors()

  constructor(session: LabSession) {
    this.#session = session
  }

  /** Does this way lie there already? */
  lies = (stage: Stage, stations: readonly number[]): boolean =>
    stations.length > 1 && this.#isThere(drawWay(stage.map, stations).scene)

  /** Where the robot stands to drive it. */
  starts = (stage: Stage, stations: readonly number[]): readonly Pose[] =>
    drawWay(stage.map, stations).scene.starts

  #isThere({ lines }: Scene): boolean {
    return JSON.stringify(this.#session.lab.document.world.lines) === JSON.stringify(lines)
  }

  /**
   * Lays it; the robot stands on its start. In tasks of their own: what was learned is on the screen before.
   * `wanted`: whether it still is, once there was time for a hand.
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

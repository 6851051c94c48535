import { robot } from '#features/robot/feature.ts'
import { loadPart } from '#parts/feature.ts'

export type RobotTool = 'build' | 'senses' | 'panel'

/** What of the robot is open on the screen: one thing at a time, so that the world is still seen. It comes with the first click that asks for any of it. */
export class RobotTools {
  #parts = $state.raw<Awaited<ReturnType<typeof robot.load>> | null>(null)
  #open = $state.raw<RobotTool | null>(null)

  get parts() {
    return this.#parts
  }

  isOpen = (tool: RobotTool) => this.#open === tool

  /** Something of it is open that stands with the world. */
  get hasDrawer(): boolean {
    return this.#open === 'senses' || this.#open === 'panel'
  }

  async show(tool: RobotTool, open: boolean): Promise<void> {
    if (open) this.#open = tool
    else if (this.#open === tool) this.#open = null
    if (open) this.#parts ??= await loadPart(robot, () => (this.#open = null))
  }
}

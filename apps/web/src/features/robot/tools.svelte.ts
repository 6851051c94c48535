import { withWords } from '#words/say.ts'

type Parts = typeof import('./later.ts')
export type RobotTool = 'build' | 'senses' | 'panel'

/** What of the robot is open on the screen: one thing at a time, so that the world is still seen. It comes with the first click that asks for any of it. */
export class RobotTools {
  #parts = $state.raw<Parts | null>(null)
  #open = $state.raw<RobotTool | null>(null)

  get parts() {
    return this.#parts
  }

  isOpen = (tool: RobotTool) => this.#open === tool

  async show(tool: RobotTool, open: boolean): Promise<void> {
    if (open) this.#open = tool
    else if (this.#open === tool) this.#open = null
    if (open) this.#parts ??= await withWords(import('./later.ts'), ['robot'], () => (this.#open = null))
  }
}

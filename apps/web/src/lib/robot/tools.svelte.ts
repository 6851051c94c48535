type Parts = typeof import('./later.ts')
export type RobotTool = 'build' | 'senses' | 'panel'

/** What of the robot is open on the screen. It comes with the first click that asks for any of it. */
export class RobotTools {
  #parts = $state.raw<Parts | null>(null)
  #open = $state.raw<ReadonlySet<RobotTool>>(new Set())

  get parts() {
    return this.#parts
  }

  isOpen = (tool: RobotTool) => this.#open.has(tool)

  async show(tool: RobotTool, open: boolean): Promise<void> {
    const others = [...this.#open].filter((other) => other !== tool)
    this.#open = new Set(open ? [...others, tool] : others)
    if (open) this.#parts ??= await import('./later.ts')
  }
}

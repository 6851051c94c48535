import type { Project } from '@botgarten/programs'
import type { LedColour, World } from '@botgarten/simulation'
import { floorToRun, type Packs } from '#lab/opening.ts'
import { RunningLab } from '#lab/running.svelte.ts'

/** A snapshot that drives on the page, to look at alone; another brain may drive beside it as a ghost. */
export class Watching {
  readonly #project: Project
  readonly #lab: RunningLab
  readonly #ghost: RunningLab | null
  readonly hasGhost: boolean

  private constructor(project: Project, lab: RunningLab, ghost: RunningLab | null) {
    this.#project = project
    this.#lab = lab
    this.#ghost = ghost
    this.hasGhost = ghost !== null
  }

  /** @param rival drives on the same floor from the same start, and neither touches the other */
  static async open(project: Project, packs: Packs, rival: Project | null = null): Promise<Watching> {
    const floor = await floorToRun(project, packs)
    if (!rival) return new Watching(project, new RunningLab(project, floor, []), null)
    await packs.loadFor(rival)
    const other = onFloorOf(project, rival)
    return new Watching(project, new RunningLab(project, floor, []), new RunningLab(other, floor, []))
  }

  get #all() {
    return this.#ghost ? [this.#lab, this.#ghost] : [this.#lab]
  }
  get running() {
    return this.#lab.view.phase === 'running' || this.#ghost?.view.phase === 'running'
  }
  get paused() {
    return this.#lab.view.phase === 'paused' || this.#ghost?.view.phase === 'paused'
  }
  get seconds() {
    return this.#lab.view.seconds
  }
  get speed() {
    return this.#lab.speed
  }
  set speed(speed: number) {
    for (const lab of this.#all) lab.speed = speed
  }

  /** The world as it stands now. */
  readonly world = $derived.by(() => standing(this.#project.world, this.#lab.view))
  readonly trails = $derived.by(() => this.#lab.view.robots.map(({ id, trail }) => ({ id, trail })))
  /** The first robot of the rival, and its way. */
  readonly ghost = $derived.by(() => {
    const robot = this.#ghost?.view.robots[0]
    const config = this.#ghost?.document.world.robots[0]?.config
    return robot && config ? { config, pose: robot.pose, trail: robot.trail } : null
  })
  led = (robot: string): LedColour | null => this.#lab.view.robots.find(({ id }) => id === robot)?.led ?? null

  /** Lets time pass until `stop` is called. */
  run(): () => void {
    const stops = this.#all.map((lab) => lab.run())
    return () => stops.forEach((stop) => stop())
  }

  toggle(): void {
    const verb = this.running ? 'pause' : this.paused ? 'resume' : 'start'
    for (const lab of this.#all) lab[verb]()
  }
  back(): void {
    for (const lab of this.#all) lab.reset()
  }
}

/** The robot of one project in the world of another, where the first one of that starts. */
function onFloorOf({ world }: Project, rival: Project): Project {
  const [place, robot] = [world.robots[0], rival.world.robots[0]]
  const robots = place && robot ? [{ ...robot, pose: place.pose }] : []
  return { ...rival, world: { ...world, robots } }
}

function standing(
  world: World,
  view: {
    readonly robots: readonly { readonly id: string; readonly pose: World['robots'][number]['pose'] }[]
    readonly obstacles: readonly { readonly id: string; readonly pose: World['obstacles'][number]['pose'] }[]
  },
): World {
  const poses = new Map([...view.robots, ...view.obstacles].map(({ id, pose }) => [id, pose]))
  const moved = <One extends { readonly id: string; readonly pose: World['robots'][number]['pose'] }>(
    one: One,
  ) => ({
    ...one,
    pose: poses.get(one.id) ?? one.pose,
  })
  return { ...world, robots: world.robots.map(moved), obstacles: world.obstacles.map(moved) }
}

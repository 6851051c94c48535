import { cardProject, type CardProgram } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { withLearnedWay } from '@botgarten/maps'
import { allCards, loadCard, type LoadedCard } from '#content/cards.ts'
import { packs } from '#features/editor/feature.ts'
import { LabSession } from '#lab/session.svelte.ts'
import { afterAll, afterEach, beforeAll, describe, expect, test, vi } from 'vitest'
import { bedOf } from '#features/home/feature.ts'
import { againFrom, nextStep } from './card.ts'

// Every card is walked to its end by the classes that the screen uses, merely because it is there.
const solutionOf = (id: string) => content.program(id, 'solution')!

/** Frames as a screen would draw them: the next one is asked for again and again. */
const screen = { next: (_: number) => {}, now: 0 }
const FRAME = 100
/** More simulated seconds than any card needs. */
const TIMEOUT = 240

beforeAll(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  vi.stubGlobal('requestAnimationFrame', (next: (now: number) => void) => {
    screen.next = next
    return 1
  })
  vi.stubGlobal('cancelAnimationFrame', () => (screen.next = () => {}))
  // Here no device keeps anything, and the autosave says so.
  vi.spyOn(console, 'warn').mockImplementation(() => {})
})
const open: LabSession[] = []
afterEach(() => {
  vi.clearAllTimers()
  for (const { autosave } of open.splice(0)) autosave.close()
})
afterAll(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

/** The card as a child has it open, with this program and these knobs. A way that is to be learned has been learned. */
async function opened(card: LoadedCard, program: CardProgram): Promise<LabSession> {
  const fresh = cardProject(card.world, card.card, program, card.card.id)
  const project = { ...fresh, ...withLearnedWay(fresh, content.mapFile) }
  const expert = await packs.loadFor(project)
  const session = new LabSession({
    ...{ id: card.card.id, revision: 0, project, card, floor: content.floorOf(project.world), expert },
    ...{ floorAddress: null, error: null, damaged: null, keeps: true },
  })
  session.learnFirst = () => false
  if (card.card.playground === 'q-learning') session.starts = () => [project.world.robots[0]!.pose]
  session.lab.speed = 16
  open.push(session)
  return session
}

/** Presses Start and looks until all goals are green, or nothing more can come. */
function runs({ lab }: LabSession, start: () => unknown): boolean {
  const stopFrames = lab.run()
  start()
  screen.now = performance.now()
  while (lab.view.phase === 'running' && lab.view.seconds < TIMEOUT && !lab.facts.succeeded)
    screen.next((screen.now += FRAME))
  stopFrames()
  return lab.facts.succeeded
}

describe.each(allCards.map(({ id }) => id))('the card %s', (id) => {
  test('is solved from place to place: each is taken, counted and followed by what comes next', async () => {
    const card = (await loadCard(id))!
    const session = await opened(card, solutionOf(id))
    const places = card.card.starts.map((_, place) => place)
    for (const place of places) {
      if (place > 0) session.chooseStart(place)
      expect(session.chosenStart).toBe(place)
      expect(runs(session, () => session.start())).toBe(true)
      expect(session.noteSuccess()).toBe(true)
      expect(session.progress.starts).toEqual(places.slice(0, place + 1))
      const next = nextStep(card, session.progress.starts)
      if (place + 1 < places.length) expect(next).toEqual({ kind: 'start', index: place + 1 })
      else if (card.card.place) expect(next).toEqual({ kind: 'zoo', href: '/zoo' })
      else if (card.card.next === null) expect(next).toEqual({ kind: 'home', href: '/' })
      else
        expect(next).toMatchObject({
          kind: 'card',
          href: expect.stringContaining(`/lab/${card.card.next}`) as string,
        })
    }
    const kept = [{ id, project: session.project, changed: 0, revision: 1 }]
    const { bed } = allCards.find((one) => one.id === id)!
    const onHome = bedOf(bed, kept, {}).find(({ href }) => href.endsWith(`/lab/${id}`))
    expect(onHome?.level).toEqual({ passed: places.length, of: places.length })
  })
})

describe('what does not count', () => {
  const forward = async (program?: CardProgram) => {
    const card = (await loadCard('forward'))!
    return opened(card, program ?? card.start)
  }
  const pose = ({ lab }: LabSession) => lab.view.robots[0]!.pose
  /** Close enough to the goal that the program at hand reaches it. */
  const near = { x: 150, y: 100, heading: 0 }

  test('Start, pressed again and again with nothing changed, does the same again and again', async () => {
    const session = await forward()
    expect(runs(session, () => session.start())).toBe(false)
    expect(session.lab.view.phase).toBe('ended')
    const end = pose(session)
    for (const _ of [2, 3, 4]) {
      expect(runs(session, () => session.start())).toBe(false)
      expect(session.beganElsewhere).toBe(false)
      expect(pose(session)).toEqual(end)
    }
  })

  test('a robot that was put somewhere stays there: it starts there, and counts nothing', async () => {
    const session = await forward()
    runs(session, () => session.start())
    session.apply({ kind: 'place', id: 'bo', after: near })
    expect(session.chosenStart).toBe(-1)
    expect(runs(session, () => session.start())).toBe(true)
    expect(session.beganElsewhere).toBe(true)
    expect(session.noteSuccess()).toBe(false)
    expect(session.progress.starts).toEqual([])
    expect(againFrom(session.opened.card!, session.chosenStart, [])).toEqual({ kind: 'again', index: 0 })
    session.chooseStart(0)
    expect(runs(session, () => session.start())).toBe(false)
  })

  test.each([
    ['puts it somewhere', (session: LabSession) => session.apply({ kind: 'place', id: 'bo', after: near })],
    ['presses a key', (session: LabSession) => session.press('up', true)],
    ['takes a step back', (session: LabSession) => session.undo.undo()],
  ])('a hand that %s while it drives has helped', async (_, help) => {
    const session = await forward(solutionOf('forward'))
    session.apply({ kind: 'place', id: 'bo', after: near })
    session.chooseStart(0)
    session.start()
    expect(session.lab.view.robots[0]!.pose.x).toBe(40)
    help(session)
    runs(session, () => {})
    expect(session.noteSuccess()).toBe(false)
    expect(session.progress.starts).toEqual([])
  })

  test('other blocks while it drives are another run, from the start place: it counts alone', async () => {
    const session = await forward()
    session.start()
    for (let ticks = 0; ticks < 30; ticks++) session.lab.step('tick')
    const { programs } = solutionOf('forward')
    session.apply({ kind: 'program', program: 'main', after: programs['main']! })
    expect(pose(session)).toEqual({ x: 40, y: 100, heading: 0 })
    session.lab.resume()
    expect(runs(session, () => {})).toBe(true)
    expect(session.noteSuccess()).toBe(true)
  })
})

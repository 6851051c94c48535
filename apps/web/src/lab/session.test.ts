import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { parseProject, sceneOf, type Program } from '@botgarten/programs'
import { samePose, TICKS_PER_SECOND, type Pose } from '@botgarten/simulation'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { LEARNED, PAUSE } from '#storage/autosave.ts'
import { load, save } from '#storage/projects.ts'
import { fillDisk, freshDevice, openTab, until } from '#storage/testing/device.ts'
import { friendship, hash, withPicture } from '#storage/testing/sample.ts'
import type { LabSession } from './session.svelte.ts'
import { card, closeSessions, screen, sessionOf } from './testing/session.ts'

addBlocks(learning)

// A session as the screen has it: real lab, real undo, real storage. Only the clock is not.
beforeEach(async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'Date'] })
  await freshDevice()
})
afterEach(() => {
  closeSessions()
  vi.useRealTimers()
})

const settle = async () => {
  for (let turns = 0; turns < 30; turns += 1) await new Promise((done) => setImmediate(done))
}
const savedProject = async () => (await load('friendship'))?.project ?? null
const bo = ({ lab }: LabSession) => lab.view.robots[0]!.pose
const pose = (x: number): Pose => ({ x, y: 300, heading: 0 })
const weight = ({ weights }: LabSession) => weights.now('net')['eyeLeft']?.['wheelRight'] ?? 0
const turn = (session: LabSession, to: number, part: 'whole' | 'start' | 'move' | 'end' = 'whole') =>
  session.weights.turn('net', 'eyeLeft', 'wheelRight', to, part)
/** Runs for so many ticks and looks at another one of them. */
function runs(session: LabSession, ticks: number, lookAt = ticks) {
  session.learnFirst = () => false
  expect(session.start()).toBeNull()
  const draw = screen()
  session.lab.speed = 16
  const stop = session.lab.run()
  session.lab.resume()
  while (session.lab.view.tick < ticks && session.lab.view.phase === 'running') draw()
  stop()
  vi.unstubAllGlobals()
  session.lab.goTo(lookAt)
}

describe('what a run has learned', () => {
  const { card, world } = content.card('try-dodge')!
  const { tables: _, ...solution } = content.program('try-dodge', 'solution')!
  const short = JSON.stringify(solution).replace(/"MINUTES":"\d+"/, '"MINUTES":"1"')
  const trying = cardProject(world, card, JSON.parse(short) as typeof solution, 'friendship')
  const learns = () => {
    const { session } = sessionOf(trying)
    expect(session.project.tables).toBeUndefined()
    runs(session, 70 * TICKS_PER_SECOND)
    expect(Object.keys(session.project.tables!)).toHaveLength(1)
    return session
  }

  test('is saved when the page is left, though no hand has changed anything', async () => {
    const session = learns()
    await session.autosave.flush()
    expect((await savedProject())?.tables).toEqual(session.project.tables)
  })

  test('is saved every few seconds while the run goes on', async () => {
    const session = learns()
    vi.advanceTimersByTime(LEARNED - 1)
    await settle()
    expect(await savedProject()).toBeNull()
    vi.advanceTimersByTime(1)
    await until(() => session.autosave.revision > 0)
    expect((await savedProject())?.tables).toEqual(session.project.tables)
  })

  test('is nothing where Bo only drives: such a run saves no project', async () => {
    const { session } = sessionOf()
    runs(session, 400)
    await session.autosave.flush()
    expect(await savedProject()).toBeNull()
  })
})

describe('every change', () => {
  test('is saved after a pause, and two of them in one save', async () => {
    const { session } = sessionOf()
    turn(session, 0.25)
    session.apply({ kind: 'place', id: 'bo', after: pose(120) })
    expect(session.autosave.state).toBe('saving')
    vi.advanceTimersByTime(PAUSE)
    await until(() => session.autosave.state === 'saved')
    const project = (await savedProject())!
    expect(project.brains['net']?.weights['eyeLeft']?.['wheelRight']).toBe(0.25)
    expect(project.world.robots[0]!.pose.x).toBe(120)
    expect(session.autosave.storage).toBe('ok')
    expect(session.autosave.id).toBe('friendship')
    expect(session.project).toEqual({ ...project, progress: { starts: [], hints: 0 } })
  })

  test('that could not be saved is said, kept, and saved once there is room', async () => {
    const { session } = sessionOf()
    const makeRoom = fillDisk()
    turn(session, 0.25)
    await session.autosave.flush()
    expect([session.autosave.state, session.autosave.storage]).toEqual(['failed', 'full'])
    expect(session.autosave.status).toMatchObject({ id: 'friendship', state: 'failed', refusal: null })
    makeRoom()
    session.autosave.retry()
    await until(() => session.autosave.state === 'saved')
    expect(await savedProject()).toEqual(session.project)
  })

  test('is told to all who listen, after it has happened, until they listen no more', () => {
    const { session, kinds } = sessionOf()
    const seen: number[] = []
    const stop = session.listen(() => seen.push(weight(session)))
    turn(session, 0.5)
    stop()
    turn(session, 0.75)
    expect(seen).toEqual([0.5])
    expect(kinds()).toEqual(['brain', 'brain'])
  })

  test('that changes nothing is none', () => {
    const { session, kinds } = sessionOf()
    expect(session.apply({ kind: 'config', id: 'bo', after: session.config })).toBe(false)
    expect(session.apply({ kind: 'config', id: 'nobody', after: session.config })).toBe(false)
    session.weights.change('net', (brain) => brain)
    expect(kinds()).toEqual([])
    expect(session.undo.canUndo).toBe(false)
    expect(session.autosave.state).toBe('saved')
  })
})

describe('two tabs with one project', () => {
  test('a session whose project another tab has saved says so and saves nothing over it', async () => {
    await save('friendship', friendship, 0)
    const { revision } = (await load('friendship'))!
    const { session } = sessionOf(friendship, { revision })
    const tab = await openTab()
    await tab.save('friendship', { ...friendship, name: 'theirs' }, revision)
    await until(() => session.autosave.state === 'elsewhere')
    turn(session, 0.25)
    vi.advanceTimersByTime(60_000)
    await settle()
    expect((await savedProject())?.name).toBe('theirs')
    await session.continueAsCopy('friendship-copy', 'mine')
    expect((await load('friendship-copy'))?.project).toEqual(session.project)
    expect([session.name, session.autosave.id, session.autosave.state]).toEqual([
      'mine',
      'friendship-copy',
      'saved',
    ])
    expect((await savedProject())?.name).toBe('theirs')
  })

  test('another name is saved like every change', async () => {
    const { session } = sessionOf()
    session.rename('mine')
    await session.autosave.flush()
    expect([session.name, (await savedProject())?.name]).toEqual(['mine', 'mine'])
  })

  test('a name that another tab gives is the name here too, and is saved with the next change', async () => {
    await save('friendship', friendship, 0)
    const { revision } = (await load('friendship'))!
    const { session } = sessionOf(friendship, { revision })
    const tab = await openTab()
    await tab.rename('friendship', 'new name')
    await until(() => session.name === 'new name')
    turn(session, 0.25)
    await session.autosave.flush()
    expect(session.autosave.state).toBe('saved')
    expect((await savedProject())?.name).toBe('new name')
  })
})

test('what can be kept nowhere is not called saved, not even before the first change', () => {
  expect(sessionOf(friendship, { keeps: false }).session.autosave.state).toBe('saving')
  expect(sessionOf().session.autosave.state).toBe('saved')
})

describe('taken back and done again', () => {
  test('a pull at a weight is one step, from where it began to where it ended', () => {
    const { session } = sessionOf()
    turn(session, 0.1, 'start')
    turn(session, 0.2, 'move')
    turn(session, 0.3, 'end')
    turn(session, 0.9)
    expect(session.undo.count).toBe(2)
    session.undo.undo()
    expect(weight(session)).toBe(0.3)
    session.undo.undo()
    expect(weight(session)).toBe(0)
    expect(session.undo.canUndo).toBe(false)
    session.undo.redo()
    session.undo.redo()
    expect(weight(session)).toBe(0.9)
    expect(session.undo.canRedo).toBe(false)
  })

  test('a pull that ends where it began is no step, and is saved all the same', () => {
    const { session } = sessionOf()
    turn(session, 0.1)
    turn(session, 0.1, 'end')
    expect(session.undo.count).toBe(1)
    session.weights.reset('net')
    expect(weight(session)).toBe(0)
    session.undo.undo()
    expect(weight(session)).toBe(0.1)
  })

  test('Bo comes back to where it stood, and its next run begins there', () => {
    const { session } = sessionOf()
    const before = bo(session)
    session.apply({ kind: 'place', id: 'bo', after: pose(100) })
    expect(bo(session).x).toBe(100)
    session.undo.undo()
    expect(bo(session)).toEqual(before)
    session.lab.reset()
    expect(bo(session)).toEqual(before)
    session.undo.redo()
    expect(bo(session).x).toBe(100)
  })

  test('a robot is built as it was; a change joined to one before goes with it', () => {
    const { session } = sessionOf()
    const { config } = session
    turn(session, 0.5)
    session.apply({ kind: 'config', id: 'bo', after: { ...config, wheelDiameter: 8 } }, 'joined')
    expect(session.config.wheelDiameter).toBe(8)
    session.undo.undo()
    expect([session.config.wheelDiameter, weight(session)]).toEqual([5.6, 0])
    session.undo.redo()
    expect([session.config.wheelDiameter, weight(session)]).toEqual([8, 0.5])
  })

  test('a scene comes back with everything where it stood, its picture stays for when it comes again', () => {
    const { session } = sessionOf()
    const { assets } = withPicture(8)
    session.apply({ kind: 'place', id: 'square', after: pose(200) })
    const scene = { ...sceneOf(session.lab.document.world), floor: { asset: hash }, obstacles: [] }
    session.apply({ kind: 'scene', after: scene, pictures: assets })
    expect(session.lab.document.world.obstacles).toEqual([])
    expect(session.lab.document.world.robots).toHaveLength(1)
    expect(session.project.assets).toEqual(assets)
    expect(session.floorUrl).toBe('data:image/png;base64,AAAAAAAA')
    session.undo.undo()
    expect(session.lab.view.obstacles.map(({ pose: { x } }) => x)).toEqual([200])
    // Only the picture that the floor lies on is kept.
    expect(session.project.assets).toEqual({})
    expect(session.pictures).toEqual(assets)
    session.undo.redo()
    expect(session.project.assets).toEqual(assets)
  })

  test('robots come and go with their programs', () => {
    const { session, kinds } = sessionOf()
    const { document } = session.lab
    const [first] = document.world.robots
    const after = {
      ...document,
      programs: { ...document.programs, second: document.programs['main']! },
      world: {
        ...document.world,
        robots: [first!, { ...first!, id: 'bo2', program: 'second', pose: pose(80) }],
      },
    }
    session.apply({ kind: 'robots', after })
    expect(session.lab.view.robots.map(({ id }) => id)).toEqual(['bo', 'bo2'])
    session.choose('bo2')
    expect([session.robotId, session.robot.program]).toEqual(['bo2', 'second'])
    session.undo.undo()
    expect(session.lab.view.robots.map(({ id }) => id)).toEqual(['bo'])
    expect(session.robotId).toBe('bo')
    expect(kinds()).toEqual(['robots', 'robots'])
  })

  test('blocks are taken back by the editor, where they are seen; not while a hand holds one', () => {
    const { session } = sessionOf()
    const asked: string[] = []
    session.noteBlocks('main')
    session.undo.undo()
    expect(session.undo.canUndo).toBe(true)
    session.moveBlocks = (direction, program) => asked.push(`${direction} ${program}`) > 0
    session.undo.undo()
    session.undo.redo()
    expect(asked).toEqual(['undo main', 'redo main'])
    // The program that they say then is what is saved.
    expect(session.autosave.state).toBe('saved')
  })

  test('blocks of another robot are taken back where they are seen', () => {
    const { session } = sessionOf()
    const { document } = session.lab
    const [first] = document.world.robots
    const robots = [first!, { ...first!, id: 'bo2', program: 'second', pose: pose(80) }]
    const programs = { ...document.programs, second: document.programs['main']! }
    session.apply({ kind: 'robots', after: { ...document, programs, world: { ...document.world, robots } } })
    session.moveBlocks = () => true
    session.noteBlocks('second')
    session.choose('bo')
    session.undo.undo()
    expect(session.robotId).toBe('bo2')
    session.noteBlocks('gone')
    session.undo.undo()
    expect(session.robotId).toBe('bo2')
  })

  test('the weights that a copied neuron takes along are no step of their own', () => {
    const { session } = sessionOf()
    turn(session, 0.5)
    session.weights.copied([{ from: 'eyeLeft', to: 'eyeRight' }])
    expect(session.weights.now('net')['eyeRight']?.['wheelRight']).toBe(0.5)
    expect(session.undo.count).toBe(1)
  })
})

describe('a program that has to be mended', () => {
  const without: Program = {
    ...friendship.programs['main']!,
    stacks: friendship.programs['main']!.stacks.map((stack) => ({
      ...stack,
      blocks: stack.blocks.filter(({ type }) => type !== 'robControls_start'),
    })),
  }
  const blind = { ...friendship.world.robots[0]!.config, sensors: {} }

  test('does not start, and the finding that stops it is given', () => {
    const { session } = sessionOf()
    expect(session.findings.filter(({ stops }) => stops)).toEqual([])
    session.apply({ kind: 'config', id: 'bo', after: blind })
    const stopping = session.findings.find(({ stops }) => stops)
    expect(stopping).toBeDefined()
    expect(session.start()).toBe(stopping)
    expect(session.lab.view.phase).toBe('ready')
    session.undo.undo()
    session.learnFirst = () => false
    expect(session.start()).toBeNull()
    expect(session.lab.view.phase).toBe('running')
  })

  test('of several robots the first one is shown', () => {
    const { session } = sessionOf()
    const { document } = session.lab
    const [first] = document.world.robots
    const robots = ['bo', 'bo2', 'bo3'].map((id, at) => ({ ...first!, id, pose: pose(80 * (at + 1)) }))
    session.apply({ kind: 'robots', after: { ...document, world: { ...document.world, robots } } })
    for (const id of ['bo3', 'bo2']) session.apply({ kind: 'config', id, after: blind })
    session.choose('bo')
    expect(session.findings.some(({ stops }) => stops)).toBe(false)
    expect(session.start()?.stops).toBe(true)
    expect(session.robotId).toBe('bo2')
  })

  test('stops when it becomes one while it runs; another change lets it run', () => {
    const { session } = sessionOf()
    runs(session, 20)
    session.lab.goTo(Infinity)
    session.lab.resume()
    turn(session, 0.3)
    expect(session.lab.view.phase).toBe('running')
    session.apply({ kind: 'config', id: 'bo', after: blind })
    expect(session.lab.view.phase).not.toBe('running')
  })

  test('is looked through again with every edit', () => {
    const { session } = sessionOf()
    const before = session.findings
    session.apply({ kind: 'program', program: 'main', after: without })
    expect(session.findings).not.toEqual(before)
    expect(session.program).toEqual(without)
  })
})

describe('in a moment of the past (rule 9)', () => {
  test('a change makes it the present, and the other future comes back as one step', () => {
    const { session, kinds } = sessionOf()
    runs(session, 60, 20)
    expect(session.lab.facts.past).toBe(true)
    turn(session, 0.5)
    expect(session.lab.facts).toMatchObject({ past: false, other: true })
    expect(session.lab.view.time.now).toBe(20)
    expect(kinds()).toEqual(['begun', 'branched', 'brain'])
    session.undo.redo()
    expect(session.lab.view.time.now).toBeGreaterThanOrEqual(60)
    expect(weight(session)).toBe(0)
  })

  test('a weight that was turned at the very tick that is gone back to is not turned there', () => {
    const { session } = sessionOf()
    runs(session, 60)
    const { tick } = session.lab.view
    turn(session, 0.5)
    const draw = screen()
    const stop = session.lab.run()
    session.resume()
    for (let frame = 0; frame < 5; frame += 1) draw()
    stop()
    expect(session.lab.view.tick).toBeGreaterThan(tick)
    session.lab.goTo(tick)
    session.goOn()
    expect([weight(session), session.undo.canUndo]).toEqual([0, false])
  })

  test('what was done before a run does not belong to a moment of it', () => {
    const { session } = sessionOf()
    turn(session, 0.5)
    runs(session, 60, 20)
    session.goOn()
    expect(session.undo.canUndo).toBe(true)
    session.undo.undo()
    expect(weight(session)).toBe(0)
  })

  test('looking alone changes nothing; going on does, and is saved', () => {
    const { session, kinds } = sessionOf()
    runs(session, 60, 20)
    session.lab.goTo(30)
    expect(kinds()).toEqual(['begun'])
    expect(session.autosave.state).toBe('saved')
    session.resume()
    expect(kinds()).toEqual(['begun', 'branched'])
    expect(session.autosave.state).toBe('saving')
    expect(session.lab.view.phase).toBe('running')
    session.goOn()
    expect(kinds()).toEqual(['begun', 'branched'])
  })
})

describe('how far a child has come', () => {
  test('a card counts as solved from the start pose that the run began on, once', async () => {
    const { session, kinds } = sessionOf()
    session.learnFirst = () => false
    expect(session.chosenStart).toBe(0)
    session.start()
    expect(session.noteSuccess()).toBe(true)
    expect(session.noteSuccess()).toBe(true)
    expect(session.progress).toEqual({ starts: [0], hints: 0 })
    expect(kinds()).toEqual(['begun', 'progress'])
    session.lab.stop()
    session.chooseStart(2)
    expect([session.chosenStart, bo(session)]).toEqual([2, card.starts[2]])
    session.start()
    session.noteSuccess()
    session.lab.stop()
    session.chooseStart(1)
    session.start()
    session.noteSuccess()
    expect(session.progress.starts).toEqual([0, 1, 2])
    await session.autosave.flush()
    expect((await savedProject())?.progress).toEqual({ starts: [0, 1, 2], hints: 0 })
  })

  test('a run that a hand has helped does not count, nor one from elsewhere', () => {
    const { session } = sessionOf()
    session.learnFirst = () => false
    session.start()
    session.press('up', false)
    expect(session.noteSuccess()).toBe(true)
    session.press('up', true)
    expect(session.noteSuccess()).toBe(false)
    session.lab.stop()
    session.apply({ kind: 'place', id: 'bo', after: pose(333) })
    expect([session.chosenStart, session.beganElsewhere]).toEqual([-1, false])
    session.start()
    expect(session.beganElsewhere).toBe(true)
    expect(session.noteSuccess()).toBe(false)
  })

  test('after a stop and a turned knob the next run begins where it counts', () => {
    const { session } = sessionOf()
    runs(session, 60)
    session.lab.stop()
    expect(bo(session)).not.toEqual(card.starts[0])
    turn(session, 0.5)
    session.start()
    expect(samePose(bo(session), card.starts[0]!)).toBe(true)
    expect([session.beganElsewhere, session.noteSuccess()]).toEqual([false, true])
  })

  test('back to the start is a place that counts: the one chosen last, the first one, or in a free lab where a hand put Bo', () => {
    const { session } = sessionOf()
    session.learnFirst = () => false
    const away = () => session.apply({ kind: 'place', id: 'bo', after: pose(333) })
    away()
    session.toStart()
    expect([session.chosenStart, samePose(bo(session), card.starts[0]!)]).toEqual([0, true])
    session.chooseStart(2)
    away()
    session.toStart()
    expect(samePose(bo(session), card.starts[2]!)).toBe(true)
    session.start()
    expect(session.noteSuccess()).toBe(true)
    session.lab.stop()
    away()
    session.toStart()
    session.undo.undo()
    expect(bo(session)).toEqual(pose(333))
    const free = sessionOf(friendship, { isCard: false }).session
    free.apply({ kind: 'place', id: 'bo', after: pose(333) })
    free.toStart()
    expect(bo(free)).toEqual(pose(333))
  })

  test('hints that were asked for are never fewer', () => {
    const { session } = sessionOf()
    session.askHint(2)
    session.askHint(1)
    expect(session.progress).toEqual({ starts: [], hints: 2 })
    expect(session.autosave.state).toBe('saving')
  })

  test('there is no start pose where there is none, and without a card', () => {
    const { session } = sessionOf()
    const before = bo(session)
    session.chooseStart(9)
    expect(bo(session)).toEqual(before)
    const free = sessionOf(friendship, { isCard: false }).session
    free.learnFirst = () => false
    free.start()
    expect([free.chosenStart, free.beganElsewhere, free.noteSuccess()]).toEqual([-1, false, false])
  })
})

describe('what else a project holds', () => {
  const learned = { seed: 1, moves: 5, key: 'k', noted: false, runs: [] }

  test('what was learned by trying belongs to the chosen robot’s program', async () => {
    const { session } = sessionOf()
    expect([session.learned, session.project.q]).toEqual([undefined, undefined])
    session.apply({ kind: 'learned', program: 'main', after: learned })
    session.apply({ kind: 'learned', program: 'other', after: { ...learned, seed: 2 } })
    expect(session.learned).toEqual(learned)
    await session.autosave.flush()
    expect((await savedProject())?.q).toEqual({ main: learned, other: { ...learned, seed: 2 } })
    expect(sessionOf(session.project).session.learned).toEqual(learned)
    expect(session.undo.count).toBe(0)
  })

  test('the shelf stays as a child has set it', () => {
    const { session } = sessionOf()
    expect([session.showsAll, session.project.shelf]).toEqual([false, undefined])
    session.apply({ kind: 'shelf', after: 'all' })
    expect([session.showsAll, session.project.shelf]).toEqual([true, 'all'])
    expect(sessionOf(session.project).session.showsAll).toBe(true)
    session.apply({ kind: 'shelf', after: 'plain' })
    expect(session.showsAll).toBe(false)
  })

  test('a project can be opened, changed and saved, and is one that can be read', () => {
    const { session } = sessionOf()
    turn(session, 0.5)
    session.askHint(1)
    expect(parseProject(JSON.parse(JSON.stringify(session.project)))).toEqual(session.project)
    expect(session.project).toMatchObject({ botgarten: 1, card: 'friendship', name: 'friendship' })
  })

  test('a program without a map learns nothing by trying, so that Start starts it', () => {
    const { session } = sessionOf()
    expect(session.learns).toBe(false)
    expect(session.start()).toBeNull()
    expect(session.lab.view.phase).toBe('running')
  })

  test('where learning comes first Start leaves the running to it', () => {
    const { session, kinds } = sessionOf()
    session.learnFirst = () => true
    expect(session.start()).toBeNull()
    expect(session.lab.view.phase).toBe('ready')
    expect(kinds()).toEqual([])
  })
})

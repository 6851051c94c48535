import { definitions, type FieldLook } from '@botgarten/blocks'
import { content } from '@botgarten/content/files'
import { mapField } from '@botgarten/blocks'
import { sceneOf, type Program } from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import { withRobot, withoutRobot } from '#lab/robots.ts'
import { language } from '#words/language.svelte.ts'
import type { Lab } from './child.svelte.ts'
import { blocksOf, copyOf, mapped } from './programs.ts'

/** Chooses with the numbers of one edit. */
export interface Pick {
  /** 0 to below `count`. */
  below(count: number): number
  of<Item>(items: readonly Item[]): Item | undefined
}

/** One kind of edit; false: it does not apply here. */
type Edit = (lab: Lab, pick: Pick) => boolean | Promise<boolean>

const looks = definitions as {
  readonly [type: string]: { readonly look: { readonly fields?: readonly FieldLook[] } }
}
const fieldsOf = (type: string) => looks[type]?.look.fields ?? []

function valueFor(field: FieldLook, pick: Pick): string | undefined {
  switch (field.kind) {
    case 'number':
      return pick.of(['', '0', '1', '-1', '7', '100', '1000', '0.5', '1e9', 'x'])
    case 'choice':
      return pick.of(field.options.map(({ value }) => value))
    case 'text':
    case 'name':
      return pick.of(['', 'a', 'Bo', 'ü'.repeat(40)])
    case 'hidden':
      return undefined
  }
}

/** Blocks of the program that can be edited: all but the start. */
const editable = (program: Program) => blocksOf(program).filter(({ type }) => type !== 'robControls_start')

const changeProgram = (lab: Lab, edit: (program: Program) => Program): boolean => {
  const before = lab.session.program
  lab.editor.change(edit)
  return lab.session.program !== before
}

const poseIn = ({ session }: Lab, pick: Pick): Pose => {
  const { width, height } = session.lab.document.world.size
  return { x: pick.below(width), y: pick.below(height), heading: pick.below(360) }
}

const changeScene = (
  { session }: Lab,
  change: (scene: ReturnType<typeof sceneOf>) => ReturnType<typeof sceneOf>,
): boolean => session.apply({ kind: 'scene', after: change(sceneOf(session.lab.document.world)) })

/** A link of the first network of the chosen robot. */
function linkOf({ session }: Lab, pick: Pick) {
  const net = session.outlines[0]
  const layers = net ? (session.lab.document.brains[net.id]?.layers ?? []) : []
  const at = pick.below(Math.max(1, layers.length - 1))
  const [from, to] = [pick.of(layers[at] ?? []), pick.of(layers[at + 1] ?? [])]
  return net && from && to ? { net: net.id, from: from.id, to: to.id } : null
}

function turn(lab: Lab, pick: Pick, parts: readonly ('whole' | 'start' | 'move' | 'end')[]): boolean {
  const link = linkOf(lab, pick)
  if (!link) return false
  for (const part of parts)
    lab.session.weights.turn(link.net, link.from, link.to, (pick.below(41) - 20) / 10, part)
  return true
}

const onMap =
  (act: (learning: NonNullable<Lab['learning']>, lab: Lab, pick: Pick) => unknown): Edit =>
  async (lab, pick) => {
    if (!lab.learning?.outline) return false
    await act(lab.learning, lab, pick)
    return true
  }

const always =
  (act: (lab: Lab, pick: Pick) => unknown): Edit =>
  async (lab, pick) => {
    await act(lab, pick)
    return true
  }

const stationIn = ({ stage }: NonNullable<Lab['learning']>, pick: Pick) =>
  pick.below(stage?.map.stations.length ?? 1)

function roadIn({ stage }: NonNullable<Lab['learning']>, pick: Pick): readonly [number, number] {
  const roads = (stage?.map.map.actions ?? []).flatMap((moves, from) =>
    moves.map(({ to }) => [from, to] as const),
  )
  return pick.of(roads) ?? [0, 1]
}

/** Kinds of edits at the playground for learning. */
export const onMapKinds = [
  ...[
    'map',
    'mapField',
    'station',
    'road',
    'pay',
    'tries',
    'learnStep',
    'learnPause',
    'learnStop',
    'learnAgain',
  ],
  ...['learnGoTo', 'guess', 'swapFloor', 'walk'],
]

/** Every kind of edit, by name. */
export const edits: { readonly [kind: string]: Edit } = {
  field: (lab, pick) => {
    const block = pick.of(editable(lab.session.program).filter(({ type }) => fieldsOf(type).length > 0))
    const field = block && pick.of(fieldsOf(block.type))
    const value = field && valueFor(field, pick)
    if (!block || !field || value === undefined) return false
    return changeProgram(lab, (program) =>
      mapped(program, (one) => [
        one.id === block.id ? { ...one, fields: { ...one.fields, [field.name]: value } } : one,
      ]),
    )
  },
  deleteBlock: (lab, pick) => {
    const block = pick.of(editable(lab.session.program))
    return (
      !!block && changeProgram(lab, (program) => mapped(program, (one) => (one.id === block.id ? [] : [one])))
    )
  },
  copyBlock: (lab, pick) => {
    const block = pick.of(editable(lab.session.program))
    if (!block) return false
    const copy = copyOf(block, `-${pick.below(1e6)}`)
    return changeProgram(lab, (program) =>
      mapped(program, (one) => (one.id === block.id ? [one, copy] : [one])),
    )
  },
  otherProgram: (lab, pick) => {
    const id = pick.of(content.cards)!.id
    const file = pick.of(['start', 'solution'])!
    return changeProgram(lab, () => content.program(id, file)!.programs['main']!)
  },
  knob: (lab, pick) => turn(lab, pick, ['whole']),
  pullKnob: (lab, pick) => turn(lab, pick, ['start', 'move', 'move', 'end']),
  resetKnobs: ({ session }) => {
    const [net] = session.outlines
    if (net) session.weights.reset(net.id)
    return net !== undefined
  },
  map: onMap(({ edits: blocks, outline }, _lab, pick) => {
    const id = pick.of(content.maps.filter((one) => one !== outline!.map))!
    const { map, start = 0, goal = map.actions.length - 1 } = content.mapFile(id)!
    blocks.setMap(id, start, goal)
  }),
  mapField: onMap(({ outline }, lab, pick) => {
    const after = mapField(pick.of(content.maps)!)
    const map = outline!.blocks.map
    lab.editor.change((program) =>
      mapped(program, (one) => [one.id === map ? { ...one, fields: { ...one.fields, MAP: after } } : one]),
    )
  }),
  station: onMap((learning, _lab, pick) =>
    learning.edits.setStation(pick.of(['START', 'FINISH'] as const)!, stationIn(learning, pick)),
  ),
  road: onMap((learning, _lab, pick) => {
    const [from, to] = roadIn(learning, pick)
    learning.edits.setRoad(from, to, pick.below(2) === 0, pick.below(2) === 0)
  }),
  pay: onMap((learning, _lab, pick) =>
    learning.edits.setOwn([String(stationIn(learning, pick))], pick.below(60) - 20),
  ),
  tries: onMap(({ outline }, lab, pick) => {
    const EPISODES = pick.of(['1', '10', '100', '0', ''])!
    const id = outline!.blocks.experience
    lab.editor.change((program) =>
      mapped(program, (one) => [one.id === id ? { ...one, fields: { ...one.fields, EPISODES } } : one]),
    )
  }),
  learnStep: onMap((learning) => learning.step()),
  learnPause: onMap((learning) => (learning.state === 'playing' ? learning.pause() : learning.play())),
  learnStop: onMap((learning) => learning.stop()),
  learnAgain: onMap((learning) => learning.again()),
  learnGoTo: onMap((learning, _lab, pick) => learning.goTo(pick.below((learning.shown?.made ?? 0) + 1))),
  guess: onMap((learning, _lab, pick) =>
    pick.below(2) === 0 ? learning.guessFirst() : learning.skipGuess(),
  ),
  swapFloor: onMap((learning) => learning.drive.swap()),
  walk: onMap((learning) => learning.walks && learning.walk()),
  place: ({ session }, pick) => {
    const pose = poseIn({ session } as Lab, pick)
    return session.apply({ kind: 'place', id: pick.of(session.lab.document.world.robots)!.id, after: pose })
  },
  placeThing: (lab, pick) => {
    const thing = pick.of(lab.session.lab.document.world.obstacles)
    return !!thing && lab.session.apply({ kind: 'place', id: thing.id, after: poseIn(lab, pick) })
  },
  addThing: (lab, pick) =>
    changeScene(lab, (scene) => ({
      ...scene,
      obstacles: [
        ...scene.obstacles,
        {
          ...{ id: `thing${pick.below(1e6)}`, colour: '#0057A6', fixed: pick.below(2) === 0 },
          shape: { kind: 'rectangle', width: 20, height: 20 },
          pose: poseIn(lab, pick),
        },
      ],
    })),
  removeThing: (lab, pick) => {
    const thing = pick.of(lab.session.lab.document.world.obstacles)
    if (!thing) return false
    return changeScene(lab, (scene) => ({
      ...scene,
      obstacles: scene.obstacles.filter(({ id }) => id !== thing.id),
    }))
  },
  paintFloor: (lab, pick) =>
    changeScene(lab, (scene) => ({
      ...scene,
      floor: { colour: pick.of(['#FFFFFF', '#00642E', '#EFE6CF'])! },
      areas: scene.areas.slice(pick.below(2)),
    })),
  worldSize: (lab, pick) =>
    changeScene(lab, (scene) => ({
      ...scene,
      size: pick.of([
        { width: 200, height: 150 },
        { width: 320, height: 200 },
      ])!,
    })),
  addRobot: ({ session }, pick) => {
    const { document } = session.lab
    if (document.world.robots.length > 3) return false
    const grown = withRobot(document, session.robotId, pick.of(['shared', 'own'] as const)!)
    session.apply({ kind: 'robots', after: grown.document })
    session.choose(grown.id)
    return true
  },
  removeRobot: ({ session }, pick) => {
    if (session.lab.document.world.robots.length < 2)
      session.apply({
        kind: 'robots',
        after: withRobot(session.lab.document, session.robotId, 'shared').document,
      })
    const { document } = session.lab
    return session.apply({
      kind: 'robots',
      after: withoutRobot(document, pick.of(document.world.robots)!.id),
    })
  },
  chooseRobot: always(({ session }, pick) => session.choose(pick.of(session.lab.document.world.robots)!.id)),
  unplug: ({ session }, pick) => {
    const port = pick.of(Object.keys(session.config.sensors))
    if (port === undefined) return false
    const { [port as keyof typeof session.config.sensors]: _, ...sensors } = session.config.sensors
    return session.apply({ kind: 'config', id: session.robotId, after: { ...session.config, sensors } })
  },
  plug: ({ session }, pick) => {
    const port = pick.of(['1', '2', '3', '4'])!
    const other = pick.of(
      content.worlds
        .map((id) => content.world(id)!)
        .flatMap(({ robots }) => Object.values(robots[0]!.config.sensors)),
    )!
    const sensors = { ...session.config.sensors, [port]: other }
    return session.apply({ kind: 'config', id: session.robotId, after: { ...session.config, sensors } })
  },
  noise: ({ session }, pick) =>
    session.apply({
      kind: 'config',
      id: session.robotId,
      after: { ...session.config, noise: pick.below(20) },
    }),
  remember: ({ session }, pick) => {
    const [net] = session.outlines
    return !!net && session.examples.remember(net.id, { left: pick.below(101), right: pick.below(101) })
  },
  language: always((_lab, pick) => language.speak(pick.of(['de', 'en'])!)),
  page: always(({ ui }, pick) => (ui.page = pick.of(['world', 'network', 'program'] as const)!)),
  fill: always(
    ({ ui }, pick) => (ui.filled = pick.of([null, 'world', 'network', 'program'] as const) ?? null),
  ),
  settings: always(
    ({ ui }, pick) => (ui.settings = { rays: pick.below(2) === 0, trail: pick.below(2) === 0 }),
  ),
  card: always(({ ui }) => (ui.cardOpen = !ui.cardOpen)),
  hint: always(({ session, ui }, pick) => {
    ui.hintOpen = !ui.hintOpen
    if (ui.hintOpen) session.askHint(1 + pick.below(3))
  }),
  toolbox: ({ session }, pick) =>
    session.apply({ kind: 'shelf', after: pick.of(['plain', 'all'] as const)! }),
  rename: always(({ session }, pick) => session.rename(pick.of(['mine', 'ü 1', 'Bo’s'])!)),
  speed: always(({ session, learning }, pick) => {
    session.lab.speed = pick.of([0.25, 1, 4, 16, Infinity])!
    if (learning) learning.player.speed = pick.of([1, 2, 3, Infinity])!
  }),
  start: always(({ ui }) => ui.start()),
  stop: always(({ session }) => session.lab.stop()),
  pause: always(({ session }) =>
    session.lab.facts.phase === 'paused' ? session.resume() : session.lab.pause(),
  ),
  step: always(({ ui }, pick) => ui.step(pick.of(['tick', 'block', 'over', 'network'] as const)!)),
  toStart: always(({ ui }) => ui.toStart()),
  otherStart: ({ ui, card }, pick) => {
    ui.chooseStart(pick.below(card.card.starts.length))
    return card.card.starts.length > 1
  },
  past: always(({ session }, pick) => session.lab.goTo(pick.below(session.lab.view.time.now + 1))),
  branch: always(({ session }) => session.goOn()),
  otherFuture: ({ session }, pick) => {
    if (!session.lab.facts.other) {
      session.lab.goTo(pick.below(session.lab.view.time.now))
      session.goOn()
    }
    return session.lab.facts.other && session.apply({ kind: 'future' })
  },
  key: always(({ session }, pick) =>
    session.press(pick.of(['up', 'down', 'left', 'right'] as const)!, pick.below(2) === 0),
  ),
  pad: always(({ session }, pick) =>
    session.lab.drive(
      pick.below(3) === 0 ? null : { left: pick.below(201) - 100, right: pick.below(201) - 100 },
    ),
  ),
  undo: always(({ ui }) => ui.go('undo')),
  redo: always(({ ui }) => ui.go('redo')),
}

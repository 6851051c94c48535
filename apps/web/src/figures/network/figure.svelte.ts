import { MediaQuery } from 'svelte/reactivity'
import type { NetTrace, Weights } from '@botgarten/learning/neural-network'
import { labelSides } from '#drawing/labels.ts'
import {
  drawHeld,
  drawKnobs,
  drawLinks,
  drawNode,
  drawSignal,
  faded,
  pulsesOf,
  shownValue,
  type LinkLook,
  type NodeLook,
  type Signal,
  type Theme,
} from '#drawing/net.ts'
import type { Command, Group } from '#drawing/commands.ts'
import type { NetworkLayout } from '#drawing/network.ts'
import { formatNumber } from '#drawing/numbers.ts'
import { distance, type Point, type Size } from '#drawing/points.ts'
import { Remembered, sameOnes, steady } from '#drawing/remembered.ts'
import { freeLine, gripsOf, knobPlaces, linksAt, stagger, type Scale, type Track } from '#drawing/track.ts'
import { letters } from '#figures/letters.svelte.ts'
import { comfort } from '#storage/comfort.svelte.ts'
import { language } from '#words/language.svelte.ts'
import type { Neuron } from './neurons.ts'

/** A network as it is shown. */
export interface NetShown {
  readonly layout: NetworkLayout
  /** Neurons from the inputs to the outputs, as the layout has places. */
  readonly columns: readonly (readonly Neuron[])[]
  readonly weights: Weights
  readonly scale: Scale
  /** Keeps resting knobs apart. */
  readonly settle?: ((tracks: readonly Track[]) => readonly Track[]) | undefined
  /** Of a big net only what is near the part that is seen is drawn. */
  readonly sees?: ((track: Track) => boolean) | undefined
  /** What of the stage is painted, in px. */
  readonly sight: Size & Point
}

/** What a hand and a run make of it. */
export interface NetUse {
  readonly trace: NetTrace | null
  /** It does not run: all of it is pale. */
  readonly idle: boolean
  /** Id of the neuron whose sum is shown. */
  readonly selected: string | null
  /** Id of the link that was touched last. */
  readonly marked: string | null
  /** Index of the link in the hand. */
  readonly held: number | null
  readonly lights: (neuron: string) => boolean
}

const atRest: NetUse = {
  trace: null,
  idle: false,
  selected: null,
  marked: null,
  held: null,
  lights: () => false,
}

/** What is painted: `neuron …`, `knob …`, `pulse`; in px of the stage. */
interface Painted extends Point {
  readonly name: string
  /** Does it light up with its block and the part of Bo? */
  readonly lit?: boolean
  /** What is written there. */
  readonly text?: string
}

/** A knob that answers to a hand. */
export interface KnobPlace {
  /** Of its link. */
  readonly index: number
  readonly at: Point
  readonly grip: number
}

const isSamePlace = (a: KnobPlace, b: KnobPlace) =>
  a.at.x === b.at.x && a.at.y === b.at.y && a.grip === b.grip

const forcedColours = new MediaQuery('(forced-colors: active)', false)

/** The theme's colour for what is chosen. A canvas apart from the page knows only the browser's own. */
function highlight(): string {
  const probe = document.body.appendChild(document.createElement('i'))
  probe.style.cssText = 'forced-color-adjust: none; color: Highlight'
  const { color } = getComputedStyle(probe)
  probe.remove()
  return color
}

/** A network as commands: links, knobs with their weights, rings with their numbers, and what travels on the links. */
export class NetFigure {
  readonly #shown: () => NetShown
  readonly #use: () => NetUse

  constructor(shown: () => NetShown, use: () => NetUse = () => atRest) {
    this.#shown = shown
    this.#use = use
  }

  readonly links = $derived.by(() => {
    const { columns } = this.#shown()
    return columns
      .slice(1)
      .flatMap((layer, l) =>
        columns[l]!.flatMap((from) => layer.map((to) => ({ id: `${from.id}→${to.id}`, from, to }))),
      )
  })

  readonly #steadyLines = steady<readonly Track[]>()
  readonly #lines = $derived.by(() => {
    const { layout, scale } = this.#shown()
    const { columns, radius } = layout
    return this.#steadyLines(
      columns
        .slice(1)
        .flatMap((ends, l) =>
          columns[l]!.flatMap((start) => ends.map((end) => freeLine(start, end, radius, scale))),
        ),
    )
  })

  // Keeping knobs apart takes its time: it is done where nodes stand, not for every weight and every look.
  readonly tracks: readonly Track[] = $derived.by(() => {
    const { settle = stagger } = this.#shown()
    return settle(this.#lines)
  })

  readonly values: readonly number[] = $derived.by(() => {
    const { weights } = this.#shown()
    return this.links.map(({ from, to }) => weights[from.id]?.[to.id] ?? 0)
  })

  /** Indices of the links that are drawn. */
  readonly seen: readonly number[] = $derived.by(() => {
    const { sees } = this.#shown()
    return [...this.links.keys()].filter((i) => sees?.(this.tracks[i]!) ?? true)
  })

  #knobsBefore: readonly KnobPlace[] = []
  /** Knobs of the links that are drawn. One that stays where it is stays the same object. */
  readonly knobs: readonly KnobPlace[] = $derived.by(() => {
    const { held } = this.#use()
    const places = knobPlaces(
      this.seen.map((i) => this.tracks[i]!),
      this.seen.map((i) => this.values[i]!),
      held === null ? null : this.seen.indexOf(held),
    )
    const grips = gripsOf(places)
    const next = this.seen.map((index, n) => ({ index, at: places[n]!, grip: grips[n]! }))
    this.#knobsBefore = sameOnes(this.#knobsBefore, next, ({ index }) => index, isSamePlace)
    return this.#knobsBefore
  })

  readonly #looks: readonly LinkLook[] = $derived.by(() => {
    const { layout } = this.#shown()
    const { idle, marked } = this.#use()
    const sides = labelSides(
      this.knobs.map(({ at }) => at),
      this.seen.map((i) => this.values[i]!),
      layout.stage,
      layout.labels === 'beside'
        ? []
        : layout.columns.flat().map(({ x, y }) => ({ x, y: y + layout.radius + 20 })),
    )
    return this.knobs.map(({ index, at, grip }, n) => {
      const { id, from, to } = this.links[index]!
      const [track, weight] = [this.tracks[index]!, this.values[index]!]
      const text = formatNumber(weight * track.unit, language.locale)
      return {
        track,
        at,
        weight,
        idle: idle || from.missing || to.missing,
        marked: marked === id,
        grip,
        label: weight === 0 ? null : { text, width: letters.widthOf(text, 18, 'title'), side: sides[n]! },
      }
    })
  })

  readonly #held: LinkLook | null = $derived.by(() => {
    const { held } = this.#use()
    return held === null ? null : (this.#looks[this.seen.indexOf(held)] ?? null)
  })

  readonly #steady = steady<readonly LinkLook[]>()
  /** All but the one in the hand: the same object while nothing else changes. */
  readonly #resting = $derived.by(() => this.#steady(this.#looks.filter((look) => look !== this.#held)))

  readonly #theme: Theme = $derived.by(() => ({
    forced: forcedColours.current ? highlight() : null,
    strong: comfort.has('projector'),
  }))
  // By themselves: what hangs on them is drawn only when they change.
  readonly #sight = $derived.by(() => this.#shown().sight)
  readonly #radius = $derived.by(() => this.#shown().layout.radius)
  readonly #links = $derived.by(() => drawLinks(this.#resting, this.#sight, this.#theme))
  readonly #knobs = $derived.by(() => drawKnobs(this.#resting, this.#sight, this.#theme))

  readonly #steadyNodes = steady<readonly (NodeLook & { readonly id: string })[]>()
  readonly #nodes = $derived.by(() => {
    const { columns, layout } = this.#shown()
    const { trace, idle, selected, lights } = this.#use()
    const nodes = columns.flatMap((layer, l) =>
      layer.map(({ id, colour, missing }, i) => ({
        id,
        at: layout.columns[l]![i]!,
        colour,
        value: trace?.outputs[id] ?? null,
        missing,
        pale: idle,
        lit: lights(id),
        chosen: selected === id,
      })),
    )
    return this.#steadyNodes(nodes)
  })

  readonly #ringLooks = new Remembered<Group>()
  /** The same shapes for what looks the same: numbers that tremble are painted once. */
  #ring({ id: _, at, ...look }: NodeLook & { readonly id: string }): Command {
    const value = look.value === null ? null : Math.round(look.value)
    const key = JSON.stringify([{ ...look, value }, this.#radius, this.#theme])
    const draw = () => drawNode({ ...look, value, at }, this.#radius, this.#theme)
    return { ...this.#ringLooks.of(key, draw), ...at }
  }
  readonly #rings = $derived.by(() => this.#nodes.map((node) => this.#ring(node)))

  /** Links a signal can be on. */
  readonly carriers = $derived.by(() => {
    const { trace } = this.#use()
    return this.seen.flatMap((i) => {
      const [{ id, from }, weight] = [this.links[i]!, this.values[i]!]
      const signal = weight * (trace?.outputs[from.id] ?? 0)
      return weight === 0 ? [] : [{ id, track: this.tracks[i]!, signal }]
    })
  })

  /** @param signals under way now */
  shapes(signals: readonly Signal[]): readonly Command[] {
    const { held, idle } = this.#use()
    const hand = this.#held
    const rest = (pale: boolean, ...shapes: readonly Command[]): Command => ({
      kind: 'group',
      opacity: pale ? faded : 1,
      shapes,
    })
    return [
      rest(idle || held !== null, this.#links),
      ...signals
        .filter(({ track }) => track !== hand?.track)
        .map((signal) => rest(held !== null, drawSignal(signal))),
      ...this.#rings,
      rest(held !== null, this.#knobs),
      ...(hand
        ? [
            drawHeld(
              hand,
              signals.filter(({ track }) => track === hand.track),
              this.#theme,
            ),
          ]
        : []),
    ]
  }

  /** The network standing still: a neuron has its colour instead of a value. */
  readonly drawing: readonly Command[] = $derived.by(() => {
    const nodes = this.#nodes.map((node) => drawNode(node, this.#radius, this.#theme, true))
    return [this.#links, ...nodes, this.#knobs]
  })

  /** Neurons, knobs and what travels between them as they are painted. */
  places(signals: readonly Signal[]): readonly Painted[] {
    return [
      ...this.#nodes.map((node) => ({
        name: `neuron ${node.id}`,
        ...node.at,
        lit: node.lit,
        text: shownValue(node),
      })),
      ...this.knobs.map(({ index, at }) => ({ name: `knob ${this.links[index]!.id}`, ...at })),
      ...signals.flatMap(pulsesOf).map((at) => ({ name: 'pulse', ...at })),
    ]
  }

  /** Name of the neuron, else of the knob whose link is meant, at a point of the stage. */
  partAt(at: Point): string | null {
    const node = this.#nodes.find((one) => distance(one.at, at) <= this.#radius)
    if (node) return `neuron ${node.id}`
    const index = linksAt(this.tracks, this.values, at)[0]
    return index === undefined ? null : `knob ${this.links[index]!.id}`
  }
}

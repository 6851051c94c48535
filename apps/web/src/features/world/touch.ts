import type { Pose } from '@botgarten/simulation'
import { clamp, type Point } from '#drawing/points.ts'
import type { Highlight } from '#figures/highlight.svelte.ts'
import type { Viewport } from '#figures/world/viewport.svelte.ts'
import { Gestures } from './gestures.ts'
import type { Hand } from './hand.svelte.ts'
import type { WorldScene } from './scene.svelte.ts'
import type { Workshop } from './workshop.ts'

interface Tools {
  readonly viewport: Viewport
  readonly hand: Hand
  readonly scene: WorldScene
  readonly highlight: Highlight | undefined
  /** Set while a child builds. */
  readonly shop: () => Workshop | null
}

/** Fingers, pens and mice in the world's pane. What they meet is what was painted last. */
export class Touch {
  readonly #tools: Tools
  readonly #fingers = new Gestures()
  #pen: number | null = null
  #pointed: string | null = null

  constructor(tools: Tools) {
    this.#tools = tools
  }

  /** A finger takes a thing, or what turns it. */
  grab(event: PointerEvent, id: string, pose: Pose, kind: 'move' | 'turn', box: HTMLElement): void {
    if (event.button !== 0) return
    event.stopPropagation()
    box.setPointerCapture(event.pointerId)
    const { viewport, hand } = this.#tools
    hand.grab(id, pose, kind, event.pointerId, viewport.floorAt(inBox(event, box)))
  }

  down(event: PointerEvent, box: HTMLElement): void {
    if (event.button !== 0) return
    const { viewport, hand, scene, highlight } = this.#tools
    const at = inBox(event, box)
    const shop = this.#tools.shop()
    if (shop?.draws && this.#pen === null) {
      box.setPointerCapture(event.pointerId)
      this.#pen = event.pointerId
      shop.draw(viewport.floorAt(at), 'start')
      return
    }
    const grabbed = scene.grabbedAt(at)
    const { selected } = scene
    if (grabbed?.kind === 'turn' && selected) return this.grab(event, selected.id, selected.pose, 'turn', box)
    if (grabbed && grabbed.kind !== 'turn') {
      highlight?.touchPart(scene.partAt(at)?.part ?? null)
      return this.grab(event, grabbed.id, grabbed.pose, 'move', box)
    }
    box.setPointerCapture(event.pointerId)
    hand.selected = null
    this.#fingers.down(event.pointerId, at)
  }

  move(event: PointerEvent, box: HTMLElement): void {
    const { viewport, hand } = this.#tools
    const at = inBox(event, box)
    if (event.pointerId === this.#pen) return this.#tools.shop()?.draw(viewport.floorAt(at), 'move')
    if (event.pointerType === 'mouse' && event.buttons === 0) this.#point(at)
    hand.move(event.pointerId, viewport.floorAt(at))
    const gesture = this.#fingers.move(event.pointerId, at)
    if (!gesture) return
    viewport.push(gesture.right, gesture.down)
    if (gesture.factor !== 1) viewport.zoom(gesture.factor, gesture.at)
  }

  up(event: PointerEvent, box: HTMLElement): void {
    const { viewport, hand } = this.#tools
    if (event.pointerId === this.#pen) {
      this.#pen = null
      return this.#tools.shop()?.draw(viewport.floorAt(inBox(event, box)), 'end')
    }
    hand.release(event.pointerId)
    this.#fingers.up(event.pointerId)
  }

  leave(): void {
    this.#pointAtPart(null)
  }

  wheel(event: WheelEvent, box: HTMLElement): void {
    event.preventDefault()
    const lines = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY
    this.#tools.viewport.zoom(1.05 ** -clamp(lines, -6, 6), inBox(event, box))
  }

  #point(at: Point): void {
    this.#pointAtPart(this.#tools.scene.partAt(at)?.part ?? null)
  }

  #pointAtPart(part: string | null): void {
    if (part !== this.#pointed) this.#tools.highlight?.pointAtPart(part)
    this.#pointed = part
  }
}

function inBox({ clientX, clientY }: PointerEvent | WheelEvent, box: HTMLElement): Point {
  const { left, top } = box.getBoundingClientRect()
  return { x: clientX - left, y: clientY - top }
}

import type { Component } from 'svelte'
import type { Pose, World } from '@botgarten/simulation'
import type { Phase } from '#drawing/nudge.ts'
import type { Point } from '#drawing/points.ts'
import type { Viewport } from '#figures/world/viewport.svelte.ts'
import type { Hand } from './hand.svelte.ts'

/** What the tools' layers on the floor are told. */
export interface LayerProps {
  readonly shop: Workshop
  readonly hand: Hand
  readonly viewport: Viewport
  readonly ondown: (event: PointerEvent, id: string, pose: Pose, kind: 'move' | 'turn') => void
}

/** Build mode as the world sees it. All of it comes with a click. */
export interface Workshop {
  /** The world with what is in the hand, as it is to be drawn. */
  readonly world: World
  /** Over the floor and under the things: areas and lines to take hold of. */
  readonly Under: Component<LayerProps>
  /** Over all: handles, and what is being drawn. */
  readonly Over: Component<LayerProps>
  /** Above and below the world. */
  readonly Tools: Component<{ shop: Workshop }>
  readonly Properties: Component<{ shop: Workshop }>
  /** Is a finger on the floor a pen? */
  readonly draws: boolean
  place(id: string, pose: Pose, phase: Phase): void
  /** The pen on the floor, in cm. */
  draw(at: Point, phase: Phase): void
  /** Returns whether the key meant something. */
  key(event: KeyboardEvent): boolean
}

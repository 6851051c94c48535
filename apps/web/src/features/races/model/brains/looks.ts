import type { LaneKind } from '@botgarten/experiments/brain-race'
import type { IconName } from '#parts/icons.ts'

interface Look {
  readonly colour: string
  readonly icon: IconName
  /** Of its line, in parts of the line's width. */
  readonly dash: string
  /** From Bo to its sign, in cm on the picture: four that stand together are told apart. */
  readonly aside: readonly [x: number, y: number]
}

/** How a lane looks: none is told by its colour alone. */
export const looks: { readonly [kind in LaneKind]: Look } = {
  hand: { colour: '#C2335F', icon: 'hand', dash: '', aside: [0, 26] },
  examples: { colour: '#1F67B3', icon: 'table', dash: '3 2.2', aside: [0, -26] },
  trying: { colour: '#5B7A12', icon: 'dice', dash: '0.1 2', aside: [-26, 0] },
  ifThen: { colour: '#B25A00', icon: 'branch', dash: '3 2 0.1 2', aside: [26, 0] },
}

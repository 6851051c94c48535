import * as Blockly from 'blockly/core'

const plugReach = 10
const plugHalf = 13

/** The left edge of a frame, drawn upwards: a corner, the plug in the middle, a corner. */
function leftEdge(height: number, radius: number, plug: 'pointed' | 'round', up: boolean): string {
  const way = up ? -1 : 1
  const straight = (height - 2 * radius) / 2 - plugHalf
  const sweep = up ? 1 : 0
  const corner = (dx: number) => `a${radius} ${radius} 0 0 ${sweep} ${dx} ${way * radius}`
  const tip =
    plug === 'pointed'
      ? `l${-plugReach} ${way * plugHalf}l${plugReach} ${way * plugHalf}`
      : `a${plugHalf} ${plugHalf} 0 0 ${sweep} 0 ${way * 2 * plugHalf}`
  return `${corner(-radius)}v${way * straight}${tip}v${way * straight}${corner(radius)}`
}

function rightEdge(height: number, radius: number, up: boolean): string {
  const way = up ? -1 : 1
  const corner = (dx: number) => `a${radius} ${radius} 0 0 ${up ? 0 : 1} ${dx} ${way * radius}`
  return `${corner(radius)}v${way * (height - 2 * radius)}${corner(-radius)}`
}

/** Outline of a layer and of the hole it goes into: a rounded frame whose plug tells inputs from outputs. */
export function layerShape(type: number, plug: 'pointed' | 'round', radius: number) {
  return {
    type,
    isDynamic: true,
    width: () => radius,
    height: (height: number) => height,
    connectionOffsetY: (height: number) => height / 2,
    connectionOffsetX: (width: number) => -width,
    pathDown: (height: number) => leftEdge(height, radius, plug, false),
    pathUp: (height: number) => leftEdge(height, radius, plug, true),
    pathRightDown: (height: number) => rightEdge(height, radius, false),
    pathRightUp: (height: number) => rightEdge(height, radius, true),
  } satisfies Blockly.blockRendering.DynamicShape
}

/** The plug alone, filled: `y` is its middle, `x` the frame's left edge. */
export function plugPath(plug: 'pointed' | 'round', x: number, y: number): string {
  const tip =
    plug === 'pointed'
      ? `l${-plugReach} ${plugHalf}l${plugReach} ${plugHalf}`
      : `a${plugHalf} ${plugHalf} 0 0 0 0 ${2 * plugHalf}`
  return `M${x} ${y - plugHalf}${tip}z`
}

import * as Blockly from 'blockly/core'
import { apricot, teal, violet } from './colours.ts'
import { FindingIcon, placeBadge } from './finding-icon.ts'
import { foot } from '../model/list.ts'
import { layerShape, plugPath } from './layer-shape.ts'

const { zelos } = Blockly
type Measurable = Blockly.blockRendering.Measurable
type Row = Blockly.blockRendering.Row

/** The edge of a growing list. */
export interface Frame {
  readonly plug: 'pointed' | 'round'
  readonly tint: 'sensor' | 'actuator' | 'hidden'
}

/** The frame of a block, where it has one: set on the block by its definition. */
const frameOf = (block: Blockly.Block | null) => (block as { frame?: Frame | null } | null)?.frame ?? null

const tints = { sensor: teal, actuator: apricot, hidden: violet }
const chevron =
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 14 14"><path d="M1.5 4l5.5 6 5.5-6" fill="none" stroke="#fff" stroke-width="2.4" stroke-linecap="round" stroke-linejoin="round"/></svg>'

const frameRadius = 20
const framePadding = 12
/** Between the network's left edge and a layer's frame. */
const layerMargin = 14
/** Of the light on the foot while a neuron is held over it. */
const footWidth = 150
const frameStroke = 3
/** Between words and the plug of a list beside them. */
const plugRoom = 8

class Constants extends zelos.ConstantProvider {
  readonly pointed = layerShape(6, 'pointed', frameRadius)
  readonly plugged = layerShape(7, 'round', frameRadius)

  constructor() {
    super()
    this.FIELD_DROPDOWN_SVG_ARROW_DATAURI = `data:image/svg+xml,${encodeURIComponent(chevron)}`
    this.FIELD_DROPDOWN_SVG_ARROW_PADDING = 6
    this.FIELD_BORDER_RECT_X_PADDING = 10
    this.FIELD_BORDER_RECT_RADIUS = 5
  }

  override shapeFor(connection: Blockly.RenderedConnection) {
    const checks = connection.getCheck() ?? connection.targetConnection?.getCheck() ?? []
    if (checks.includes('InputLayer')) return this.pointed
    if (checks.includes('OutputLayer')) return this.plugged
    // Where anything fits, nothing says that it must be a truth.
    const isOpen = checks.length > 1 && checks.includes('Boolean')
    return isOpen ? this.ROUNDED! : super.shapeFor(connection)
  }
}

/** Measures a block. The badge of a finding takes no room, a layer keeps its plug inside the network. */
class Info extends zelos.RenderInfo {
  protected override createRows_() {
    super.createRows_()
    const [first] = this.inputRows
    if (first) first.elements = first.elements.filter((element) => !isBadge(element))
  }

  override getInRowSpacing_(prev: Measurable | null, next: Measurable | null) {
    const spacing = super.getInRowSpacing_(prev, next)
    const first = prev === null && next !== null && hasLayers(this.block_)
    if (first && !isPicture(next)) return layerMargin
    return prev && next && holdsFrame(next) ? spacing + plugRoom : spacing
  }

  override getSpacerRowHeight_(prev: Row, next: Row) {
    return next.elements.some(holdsLayer) ? 0 : super.getSpacerRowHeight_(prev, next)
  }
}

const { Types } = Blockly.blockRendering
const isBadge = (element: Measurable) => Types.isIcon(element) && element.icon instanceof FindingIcon
/** The socket at the foot of a list shows only when something is held over it. */
const isFreeFoot = (element: Measurable): element is Blockly.blockRendering.InlineInput =>
  Types.isInlineInput(element) && element.input.name === foot && !element.connectedBlock
const isPicture = (element: Measurable) =>
  Types.isField(element) && element.field instanceof Blockly.FieldImage
const takesLayer = (input: Blockly.Input) =>
  /^(In|Out)putLayer$/.test(String(input.connection?.getCheck()?.[0]))
const holdsLayer = (element: Measurable) => Types.isInlineInput(element) && takesLayer(element.input)
const holdsFrame = (element: Measurable) =>
  Types.isInlineInput(element) && frameOf(element.connectedBlock) !== null
const hasLayers = (block: Blockly.Block) => block.inputList.some(takesLayer)

/** Measures a framed list: what stands in it keeps 12 from the edge instead of zelos's half circle. */
class FrameInfo extends Info {
  protected override getNegativeSpacing_() {
    return frameRadius - framePadding
  }

  protected override createRows_() {
    super.createRows_()
    for (const row of this.inputRows) {
      for (const element of row.elements) if (isFreeFoot(element)) element.width = 0
    }
  }

  override getInRowSpacing_(prev: Measurable | null, next: Measurable | null) {
    return prev !== null && isFreeFoot(prev) ? 0 : super.getInRowSpacing_(prev, next)
  }

  override getSpacerRowHeight_(prev: Row, next: Row) {
    if (Types.isTopRow(prev)) return 6
    if (Types.isBottomRow(next)) return 3
    return super.getSpacerRowHeight_(prev, next)
  }
}

class Drawer extends zelos.Drawer {
  override draw() {
    super.draw()
    const path = this.block_.pathObject
    const frame = frameOf(this.block_)
    if (path instanceof PathObject) path.setPlug(frame && plugPath(frame.plug, 0, this.info_.height / 2))
    placeBadge(this.block_)
  }

  override drawInlineInput_(input: Blockly.blockRendering.InlineInput) {
    if (isFreeFoot(input)) this.positionInlineInputConnection_(input)
    else super.drawInlineInput_(input)
  }

  override drawConnectionHighlightPath(measurable: Blockly.blockRendering.Connection) {
    if (isFreeFoot(measurable)) measurable.width = footWidth
    return super.drawConnectionHighlightPath(measurable)
  }
}

class PathObject extends zelos.PathObject {
  #plug: SVGElement | null = null

  override applyColour(block: Blockly.BlockSvg) {
    super.applyColour(block)
    const frame = frameOf(block)
    const inside = !frame && frameOf(block.getParent()) !== null
    if (frame) this.svgPath.setAttribute('stroke', tints[frame.tint])
    if (inside) this.svgPath.setAttribute('stroke', '#fff')
    this.svgPath.setAttribute('stroke-opacity', inside ? '0.35' : '1')
    this.svgPath.setAttribute('stroke-width', String(frame ? frameStroke : 1))
    this.#plug?.setAttribute('fill', frame ? tints[frame.tint] : 'none')
  }

  setPlug(path: string | null) {
    if (path === null) return
    this.#plug ??= Blockly.utils.dom.createSvgElement('path', { class: 'editor-plug' }, this.svgRoot)
    this.#plug.setAttribute('d', path)
    this.#plug.setAttribute('fill', this.svgPath.getAttribute('stroke') ?? 'none')
  }
}

class Renderer extends zelos.Renderer {
  protected override makeConstants_() {
    return new Constants()
  }

  protected override makeRenderInfo_(block: Blockly.BlockSvg) {
    return frameOf(block) ? new FrameInfo(this, block) : new Info(this, block)
  }

  protected override makeDrawer_(block: Blockly.BlockSvg, info: Blockly.zelos.RenderInfo) {
    return new Drawer(block, info)
  }

  override makePathObject(root: SVGElement, style: Blockly.Theme.BlockStyle) {
    return new PathObject(root, style, this.getConstants())
  }
}

export const rendererName = 'botgarten'
Blockly.blockRendering.register(rendererName, Renderer)

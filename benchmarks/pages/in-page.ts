import type { Box, Colour, SeenPart, SeenPaper, SeenText } from './seen.ts'

// Runs inside the page: nothing from outside a function is there.

/** All that stands on the paper that is open. The window has to be as large as the page. */
export function lookAtPaper(): SeenPaper {
  const paper = document.querySelector<HTMLElement>('.paper')!
  const homes = [...paper.querySelectorAll('.leaf, .flow')]
  const style = document.createElement('style')
  style.textContent = '* { pointer-events: visiblePainted !important }'
  document.head.append(style)
  const shapes = 'path, rect, circle, ellipse, line, polygon, polyline, use, image, text'

  const boxOf = ({ left, top, right, bottom }: DOMRect): Box => ({ left, top, right, bottom })
  const homeOf = (element: Element) => homes.findIndex((home) => home.contains(element))

  /** Asked for once an element. */
  function kept<Answer>(ask: (element: Element) => Answer) {
    const answers = new Map<Element, Answer>()
    return (element: Element): Answer => {
      if (!answers.has(element)) answers.set(element, ask(element))
      return answers.get(element)!
    }
  }

  function upwards(element: Element): Element[] {
    const all: Element[] = []
    for (let one: Element | null = element; one && one !== paper; one = one.parentElement) all.push(one)
    return all
  }

  const isForEars = kept((element) =>
    upwards(element).some((one) => {
      const { clipPath, display, visibility, opacity } = getComputedStyle(one)
      return (
        one.matches('.for-ears-only') ||
        clipPath.startsWith('inset(50%') ||
        display === 'none' ||
        visibility === 'hidden' ||
        opacity === '0'
      )
    }),
  )

  /** What cuts what stands out of it; what is placed freely is cut from the box on that it is placed in. */
  const cutting = kept((element) => {
    let free = false
    return upwards(element).filter((one) => {
      const { position, overflowX } = getComputedStyle(one)
      if (free && position === 'static') return false
      free = position === 'absolute'
      return homes.includes(one) || overflowX !== 'visible'
    })
  })
  const boxesOf = (elements: readonly Element[]) =>
    elements.map((element) => boxOf(element.getBoundingClientRect()))

  const canvas = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!
  function colourOf(css: string, opacity = 1): Colour {
    canvas.clearRect(0, 0, 1, 1)
    canvas.fillStyle = css
    canvas.fillRect(0, 0, 1, 1)
    const [r = 0, g = 0, b = 0, a = 0] = canvas.getImageData(0, 0, 1, 1).data
    return [r, g, b, (a / 255) * opacity]
  }

  const opacityOf = kept((element) =>
    upwards(element).reduce((product, one) => product * Number(getComputedStyle(one).opacity), 1),
  )

  /** What an element lays on the paper; null: a picture. */
  const paintOf = kept((element): Colour | null => {
    const css = getComputedStyle(element)
    const opacity = opacityOf(element)
    if (element instanceof HTMLImageElement || element instanceof SVGImageElement) return null
    if (!(element instanceof SVGElement) || element instanceof SVGSVGElement) {
      if (css.backgroundImage !== 'none') return null
      return colourOf(css.backgroundColor, opacity)
    }
    if (element.closest('text')) return [0, 0, 0, 0]
    if (css.fill.startsWith('url')) return null
    if (css.fill !== 'none') return colourOf(css.fill, opacity * Number(css.fillOpacity))
    return css.stroke === 'none' ? [0, 0, 0, 0] : colourOf(css.stroke, opacity * Number(css.strokeOpacity))
  })

  /** What lies below a point of a text, and what lies over it. */
  function layersAt(x: number, y: number, own: Element) {
    const stack = document.elementsFromPoint(x, y)
    const at = stack.findIndex((one) => one === own || one.contains(own) || own.contains(one))
    const over = stack.slice(0, Math.max(0, at)).find((one) => {
      const paint = paintOf(one)
      return paint === null || paint[3] > 0.5
    })
    const below: Colour[] = []
    for (const one of stack.slice(Math.max(0, at))) {
      const paint = paintOf(one)
      if (paint === null) return { over, below: null }
      if (paint[3] > 0) below.push(paint)
      if (paint[3] > 0.99) break
    }
    return { over, below }
  }

  function pixelsOf(element: Element): number {
    const size = parseFloat(getComputedStyle(element).fontSize)
    const drawn = element.closest<SVGTextElement>('text')
    if (drawn) return (size * drawn.getBoundingClientRect().height) / (drawn.getBBox().height || 1)
    return size * (element.currentCSSZoom || 1)
  }

  function linesOf(node: Text, of: number): SeenText[] {
    const element = node.parentElement!
    if (isForEars(element)) return []
    const css = getComputedStyle(element)
    const range = document.createRange()
    range.selectNodeContents(node)
    const drawn = element.closest('svg') !== null
    const seen = {
      text: node.data.trim().replace(/\s+/g, ' '),
      of,
      home: homeOf(element),
      points: (pixelsOf(element) * 72) / 96,
      bold: Number(css.fontWeight) >= 700,
      drawn: drawn || element.closest('figure') !== null,
      language: element.closest('[lang]')!.getAttribute('lang')!.slice(0, 2),
      colour: colourOf(drawn ? css.fill : css.color, opacityOf(element)),
      within: boxesOf(cutting(element)),
    }
    return [...range.getClientRects()]
      .filter(({ width, height }) => width > 1 && height > 1)
      .map((rect) => {
        const layers = [0.1, 0.5, 0.9].map((share) =>
          layersAt(rect.left + share * rect.width, rect.top + rect.height / 2, element),
        )
        const over = layers.find((layer) => layer.over)?.over
        return {
          ...seen,
          box: boxOf(rect),
          below: layers.map(({ below }) => below),
          coveredBy: over ? `<${over.tagName.toLowerCase()} ${over.getAttribute('class') ?? ''}>` : null,
        }
      })
  }

  function texts(): SeenText[] {
    const walker = document.createTreeWalker(paper, NodeFilter.SHOW_TEXT)
    const all: Text[] = []
    while (walker.nextNode()) all.push(walker.currentNode as Text)
    return all
      .filter((node) => node.data.trim() !== '' && !node.parentElement!.closest('style, script, title'))
      .flatMap(linesOf)
  }

  const marksOf = (element: Element) =>
    element.textContent.trim().length +
    element.querySelectorAll(shapes).length +
    [element, ...element.querySelectorAll('img')].filter(
      (one) => one instanceof HTMLImageElement && one.naturalWidth > 0,
    ).length

  function parts(): SeenPart[] {
    const all = [
      ...paper.querySelectorAll('figure, img, table, section, .paper-code, .things, .bo, svg'),
    ].filter((element) => !isForEars(element) && !element.parentElement!.closest('svg, figure, .bo'))
    return all.map((element) => ({
      name: element.getAttribute('aria-label') ?? element.getAttribute('alt') ?? element.localName,
      box: boxOf(element.getBoundingClientRect()),
      home: homeOf(element),
      inside: all.flatMap((other, number) => (other !== element && other.contains(element) ? [number] : [])),
      marks: marksOf(element),
      within: boxesOf(cutting(element).filter((one) => one !== element)),
    }))
  }

  const names = [...paper.querySelectorAll('[aria-label], [alt]')].map((element) => ({
    text: element.getAttribute('aria-label') ?? element.getAttribute('alt') ?? '',
    language: element.closest('[lang]')!.getAttribute('lang')!.slice(0, 2),
  }))
  const seen = { language: document.documentElement.lang.slice(0, 2), texts: texts(), parts: parts(), names }
  style.remove()
  return seen
}

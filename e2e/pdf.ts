import { getDocument, OPS, type PDFDocumentProxy } from 'unpdf/pdfjs'

/** What can be read of a PDF without looking at it. */
export interface ReadPdf {
  readonly title: string
  readonly language: string | null
  readonly tagged: boolean
  /** Titles of the outline's first level. */
  readonly outline: readonly string[]
  readonly pages: readonly ReadPage[]
}

interface ReadPage {
  /** In whole mm: Chromium rounds to its pixels. */
  readonly width: number
  readonly height: number
  readonly text: string
  /** Addresses that a tap opens. */
  readonly links: readonly string[]
  /** Fonts that it names and does not bring along. */
  readonly missingFonts: readonly string[]
  /** Words that stand beyond its edges. */
  readonly outside: readonly string[]
  /** Letters, lines and pictures on it. */
  readonly marks: number
  /** Levels of its headings, from the top down. */
  readonly headings: readonly number[]
  /** Figures, and how many of them say nothing to ears. */
  readonly figures: number
  readonly silentFigures: number
}

const mm = (points: number) => Math.round((points / 72) * 25.4)

const opens = (bytes: Uint8Array) =>
  getDocument({ data: new Uint8Array(bytes), verbosity: 0, useSystemFonts: false })

/** Of a long file only how large its pages are, and their headings: letters and pictures take twenty times as long. */
export async function readOutside(
  bytes: Uint8Array,
): Promise<readonly Pick<ReadPage, 'width' | 'height' | 'headings'>[]> {
  const task = opens(bytes)
  const pdf = await task.promise
  const numbers = Array.from({ length: pdf.numPages }, (_, index) => index + 1)
  const pages = await Promise.all(
    numbers.map(async (number) => {
      const page = await pdf.getPage(number)
      return { ...sizeOf(page.view), headings: headingsIn(rolesOf(await page.getStructTree())) }
    }),
  )
  await task.destroy()
  return pages
}

export async function readPdf(bytes: Uint8Array): Promise<ReadPdf> {
  const task = opens(bytes)
  const pdf = await task.promise
  const [{ info }, mark, outline] = await Promise.all([
    pdf.getMetadata(),
    pdf.getMarkInfo(),
    pdf.getOutline(),
  ])
  const { Title = '', Language = null } = info as { Title?: string; Language?: string | null }
  const pages = await Promise.all(
    Array.from({ length: pdf.numPages }, (_, index) => readPage(pdf, index + 1)),
  )
  await task.destroy()
  return {
    title: Title,
    language: Language,
    tagged: mark?.Marked === true,
    outline: (outline as { title: string }[] | null)?.map(({ title }) => title) ?? [],
    pages,
  }
}

async function readPage(pdf: PDFDocumentProxy, number: number): Promise<ReadPage> {
  const page = await pdf.getPage(number)
  const [left, bottom, right, top] = page.view as [number, number, number, number]
  const content = await page.getTextContent()
  const roles = rolesOf(await page.getStructTree())
  const figures = roles.filter(({ role }) => role === 'Figure')
  const links = (await page.getAnnotations()) as { url?: string }[]
  return {
    ...sizeOf(page.view),
    text: content.items
      .map((item) => ('str' in item ? item.str + (item.hasEOL ? ' ' : '') : ''))
      .join('')
      .replace(/\s+/g, ' '),
    links: links.flatMap(({ url }) => url ?? []),
    missingFonts: await missingFonts(page),
    outside: content.items.flatMap((item) => {
      if (!('str' in item) || item.str.trim() === '') return []
      const [x, y] = item.transform.slice(4) as [number, number]
      const inside =
        x >= left - 1 && x + item.width <= right + 1 && y >= bottom - 1 && y + item.height <= top + 1
      return inside ? [] : [item.str]
    }),
    marks: await marksOn(page),
    headings: headingsIn(roles),
    figures: figures.length,
    silentFigures: figures.filter(({ alt }) => !alt?.trim()).length,
  }
}

function sizeOf(view: readonly number[]): { readonly width: number; readonly height: number } {
  const [left, bottom, right, top] = view as [number, number, number, number]
  return { width: mm(right - left), height: mm(top - bottom) }
}

const headingsIn = (roles: readonly StructNode[]): number[] =>
  roles.flatMap(({ role }) => /^H([1-6])$/.exec(role)?.[1] ?? []).map(Number)

interface StructNode {
  readonly role: string
  readonly alt?: string
  readonly children?: readonly (StructNode | { readonly type: string })[]
}

const rolesOf = (node: StructNode | null): StructNode[] =>
  node === null
    ? []
    : [node, ...(node.children ?? []).flatMap((child) => ('role' in child ? rolesOf(child) : []))]

const painting = new Set([
  OPS.showText,
  OPS.constructPath,
  OPS.paintImageXObject,
  OPS.paintInlineImageXObject,
  OPS.paintImageMaskXObject,
])

async function marksOn(page: Awaited<ReturnType<PDFDocumentProxy['getPage']>>): Promise<number> {
  const { fnArray } = await page.getOperatorList()
  return fnArray.filter((fn) => painting.has(fn)).length
}

async function missingFonts(page: Awaited<ReturnType<PDFDocumentProxy['getPage']>>): Promise<string[]> {
  const { fnArray, argsArray } = await page.getOperatorList()
  const names = fnArray.flatMap((fn, index) =>
    fn === OPS.setFont ? [String((argsArray[index] as unknown[])[0])] : [],
  )
  return [...new Set(names)].filter((name) => {
    const font = page.commonObjs.get(name) as { missingFile?: boolean }
    return font.missingFile === true
  })
}

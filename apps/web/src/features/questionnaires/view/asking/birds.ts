import type { Bird } from '@botgarten/answers'

/** How a bird is coloured. */
interface Look {
  readonly body: string
  readonly belly: string
  readonly beak: string
  readonly cap?: string
}

export const looks: { readonly [bird in Bird]: Look } = {
  blackbird: { body: '#4A4140', belly: '#5B5150', beak: '#F2A33A' },
  robin: { body: '#9B7A55', belly: '#E8793A', beak: '#4A3428' },
  'blue-tit': { body: '#5FA8D3', belly: '#FFD76A', beak: '#4A3428', cap: '#2F6FA5' },
  sparrow: { body: '#A9754B', belly: '#EAD9C2', beak: '#4A3428', cap: '#7A4A28' },
  greenfinch: { body: '#8BA63C', belly: '#C7D46A', beak: '#E8B9A0' },
  swallow: { body: '#3F5E8C', belly: '#FFFDF8', beak: '#4A3428' },
  woodpecker: { body: '#3A2A20', belly: '#FFFDF8', beak: '#6B5545', cap: '#E4604A' },
  pigeon: { body: '#9FAFBC', belly: '#C9B3C9', beak: '#8C7152' },
  magpie: { body: '#26323F', belly: '#FFFFFF', beak: '#26323F', cap: '#2F6F73' },
  bullfinch: { body: '#7F8790', belly: '#E2665C', beak: '#2E2622', cap: '#2E2622' },
  kingfisher: { body: '#1E87B8', belly: '#EE8433', beak: '#2E2622' },
  wren: { body: '#8A5A36', belly: '#C99A6B', beak: '#6B5545' },
  nuthatch: { body: '#7893AE', belly: '#F3C491', beak: '#4A4A4A', cap: '#4F6A88' },
  starling: { body: '#3E3A55', belly: '#5A6B5A', beak: '#F0C63C' },
  goldfinch: { body: '#C39A63', belly: '#FFF3DC', beak: '#EAD3B0', cap: '#D23B32' },
  stork: { body: '#FFFDF8', belly: '#FFFDF8', beak: '#E0452F', cap: '#FFFDF8' },
  owl: { body: '#B98A55', belly: '#EBD3A8', beak: '#D9A441', cap: '#8A5F33' },
  duck: { body: '#8C7A6A', belly: '#B59A82', beak: '#E8C22F', cap: '#1F7A45' },
  swan: { body: '#FFFFFF', belly: '#F4F1E8', beak: '#F08A2C' },
  crane: { body: '#A9B4BC', belly: '#C7D0D6', beak: '#8C8A6A', cap: '#C23A30' },
  jay: { body: '#C99779', belly: '#8CBFE0', beak: '#3A2A20', cap: '#E8D6C6' },
  cuckoo: { body: '#8A97A6', belly: '#E9E9E4', beak: '#E5B93C' },
  heron: { body: '#8FA1B3', belly: '#F4F4EF', beak: '#E9A03B', cap: '#2E3A46' },
  oriole: { body: '#F2C230', belly: '#F7DA6E', beak: '#B9483A' },
}

export default {
  outdir: './src/words/generated',
  strategy: ['baseLocale'],
  outputStructure: 'locale-modules',
  emitTsDeclarations: true,
}

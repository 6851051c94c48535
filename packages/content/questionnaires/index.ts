export type * from '../schema/formTypes.ts'
export { moments, steps, topics } from '../schema/formTypes.ts'
export {
  missingIn,
  readForm,
  readFormFile,
  readFormText,
  writeFormFile,
  type LoadedForm,
} from '../schema/form.ts'

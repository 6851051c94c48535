// What is drawn at blocks while a child looks closely.
import './marks.css'

export { showMarks } from './marks.ts'
